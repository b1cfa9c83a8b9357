package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * What clients of the stream are told of one kind of thing; {@link Topics} has all of them, {@link TopicFeed} carries them.
 *
 * @param message what is said of one that has changed
 * @param rate how often
 * @param subject what a message is about: what waits of it is replaced by what is newer, and withheld when it is out of sight
 * @param audience whom it is shown to
 * @param picture what one of them is told
 * @param atFirst those that a client is told of when it has come in
 * @param removal what is said of one that is gone or out of sight; null: nothing
 * @param source has a feed hear of each change, from any thread
 * @param <T> a thing as it is at one moment
 */
record Topic<T>(
        Class<? extends StreamMessage> message,
        Rate rate,
        Function<T, Subject> subject,
        Audience<T> audience,
        BiFunction<T, Principal, StreamMessage> picture,
        Supplier<? extends Collection<T>> atFirst,
        @Nullable Removal removal,
        Consumer<TopicFeed<T>> source) {

    /** What is said of a thing that is gone, by its id. */
    record Removal(Class<? extends StreamMessage> message, Function<String, StreamMessage> of) {}

    /** Whom a thing is shown to: in words for people, and by its {@link Sight}. */
    record Audience<T>(String words, Sight<T> sight) {
        /** For all of whom it looks alike. */
        static <T> Audience<T> of(String words, Test<T> isShown) {
            return new Audience<>(words, (who, thing) -> isShown.isShownTo(who, thing) ? Boolean.TRUE : null);
        }
    }

    /** Whether a thing is shown to somebody. */
    interface Test<T> {
        boolean isShownTo(Principal who, T thing);
    }

    /** What somebody sees of a thing. */
    interface Sight<T> {
        /** Null: nothing. For all to whom it says the same the thing looks alike: it is written once for them. */
        @Nullable
        Object of(Principal who, T thing);
    }
}
