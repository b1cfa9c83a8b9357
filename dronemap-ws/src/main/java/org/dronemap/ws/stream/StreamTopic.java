package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.jspecify.annotations.Nullable;

/**
 * One kind of update sent on the WebSocket stream: its message, rate, audience and source. A feature declares its own
 * beside its use case, as a bean; {@link StreamTopicFeed} carries them.
 *
 * @param message what is said of one that has changed
 * @param rate how often
 * @param about what a message is about: what waits of it is replaced by what is newer, and withheld when it is out of sight
 * @param audience whom it is shown to
 * @param picture what one of them is told
 * @param atFirst those that a client is told of when it has come in
 * @param removal what is said of one that is gone or out of sight; null: nothing
 * @param source has a feed hear of each change, from any thread
 * @param <T> a thing as it is at one moment
 */
public record StreamTopic<T>(
        Class<? extends StreamMessage> message,
        StreamTopicRate rate,
        SubjectMapping<T> about,
        Audience<T> audience,
        BiFunction<T, Principal, StreamMessage> picture,
        Supplier<? extends Collection<T>> atFirst,
        @Nullable Removal removal,
        Consumer<StreamTopicSink<T>> source) {

    /**
     * The subjects of messages, by a word for their kind and an id that is unique among things of one kind. What is of kind
     * {@code drone}, by the drone's id, goes by what a client has subscribed to.
     */
    public record SubjectMapping<T>(String kind, Function<T, String> id) {
        /** Of what is or belongs to a drone. */
        public static <T> SubjectMapping<T> ofDrone(Function<T, DroneId> drone) {
            return new SubjectMapping<>(
                    StreamMessageSubject.DRONE, thing -> drone.apply(thing).value());
        }

        StreamMessageSubject subject(T thing) {
            return subject(id.apply(thing));
        }

        StreamMessageSubject subject(String thing) {
            return new StreamMessageSubject(kind, thing);
        }
    }

    /** Message that clients get about a removed thing, built from its id. */
    public record Removal(Class<? extends StreamMessage> message, Function<String, StreamMessage> of) {}

    /** Audience of a topic: in words for people, and as its {@link Sight}. */
    public record Audience<T>(String words, Sight<T> sight) {
        /** For all of whom it looks alike. */
        public static <T> Audience<T> of(String words, Test<T> isShown) {
            return new Audience<>(words, (who, thing) -> isShown.isShownTo(who, thing) ? Boolean.TRUE : null);
        }
    }

    /** Predicate that decides if a thing is shown to a user. */
    public interface Test<T> {
        boolean isShownTo(Principal who, T thing);
    }

    /** Function that gives a key for what a user may see of a thing; users with equal keys get the same message. */
    public interface Sight<T> {
        /** Null: nothing. For all to whom it says the same the thing looks alike: it is written once for them. */
        @Nullable
        Object of(Principal who, T thing);
    }

    /** What it tells: of things that have changed, and of those that are gone. */
    public List<Class<? extends StreamMessage>> messages() {
        return removal == null ? List.of(message) : List.of(message, removal.message());
    }

    /** Whether clients are told when a thing is out of sight. */
    boolean isWithdrawn() {
        return removal != null;
    }
}
