package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.annotation.JsonTypeName;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.java_websocket.WebSocket;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What each topic does with changes, whatever its things are; here they are names, and their subject is the first letter. */
class StreamTopicFeedTest {
    private static final long MILLI = 1_000_000L;
    private static final String A = "a";

    @JsonTypeName("gone")
    record Gone(String id) implements StreamMessage.OfUseCase {}

    private final Set<String> hidden = new HashSet<>();
    private final List<String> things = new ArrayList<>(List.of("a1"));
    private final StreamClient anna = client("anna");
    private final StreamClient bert = client("bert");
    private final List<StreamClient> clients = List.of(anna, bert);

    private static StreamClient client(String user) {
        StreamClient client = admitted(user);
        client.setGreeted();
        return client;
    }

    private static StreamClient admitted(String user) {
        WebSocket socket = (WebSocket) Proxy.newProxyInstance(
                WebSocket.class.getClassLoader(), new Class<?>[] {WebSocket.class}, (p, m, a) -> {
                    throw new UnsupportedOperationException(m.getName());
                });
        StreamClient client = new StreamClient(socket, 0);
        client.admit(new AuthenticatedCaller(
                new Principal(user, Role.VIEWER), AuthenticatedCaller.Proof.KEY, null, null, false));
        return client;
    }

    private StreamTopicFeed<String> feed(StreamTopicRate rate) {
        return feed(rate, new StreamTopic.Removal(Gone.class, Gone::new));
    }

    private StreamTopicFeed<String> feed(StreamTopicRate rate, StreamTopic.@Nullable Removal removal) {
        StreamTopic<String> topic = new StreamTopic<>(
                StreamMessage.Hello.class,
                rate,
                new StreamTopic.SubjectMapping<>("name", name -> name.substring(0, 1)),
                StreamTopic.Audience.of("all but some", (who, name) -> !hidden.contains(who.name() + name)),
                (name, who) -> new StreamMessage.Hello(name, "shown", "1.2"),
                () -> things,
                removal,
                feed -> {});
        return new StreamTopicFeed<>(topic, new JsonCodec(), clients, () -> {});
    }

    private static List<String> heard(StreamClient client) {
        return client.outbox().drain().stream()
                .map(text -> text.replaceAll(".*\"(?:user|id)\":\"(\\w+)\".*", "$1"))
                .toList();
    }

    /** Otherwise what happens just then would come before the greeting. */
    @Test
    void tellsNothingToWhoIsNotGreetedYet() {
        StreamClient early = admitted("early");
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.EveryChange());
        feed.settle(List.of(early));
        assertThat(heard(early)).isEmpty();

        early.setGreeted();
        feed.settle(List.of(early));
        assertThat(heard(early)).containsExactly("a1");
    }

    @Test
    void tellsTheNewestStateAloneAndNotTooOften() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.Newest(4));
        feed.changed(A, () -> Optional.of("a1"));
        feed.changed(A, () -> Optional.of("a2"));
        feed.publish(0);
        assertThat(heard(anna)).containsExactly("a2");

        feed.changed(A, () -> Optional.of("a3"));
        feed.publish(249 * MILLI);
        assertThat(heard(anna)).isEmpty();
        feed.publish(250 * MILLI);
        assertThat(heard(anna)).containsExactly("a3");
    }

    @Test
    void tellsAtOnceWhatCannotWait() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.Newest(4));
        feed.changed(A, () -> Optional.of("a1"));
        feed.publish(0);
        feed.changedAtOnce(A, () -> Optional.of("a2"));
        feed.changed(A, () -> Optional.of("a3"));
        feed.publish(MILLI);
        assertThat(heard(anna)).containsExactly("a3");
    }

    @Test
    void tellsOnlyThoseOfARemovalWhoWereShownWhatIsGone() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.Newest(4));
        hidden.add("berta1");
        feed.changed(A, () -> Optional.of("a1"));
        feed.publish(0);
        feed.changed(A, () -> Optional.of("a1"));
        feed.removed(A);
        feed.publishRemovals();
        feed.publish(1_000 * MILLI);

        assertThat(heard(anna)).as("no picture follows it").containsExactly("a");
        assertThat(heard(bert)).isEmpty();
    }

    @Test
    void takesBackWhatIsOutOfSightAndShowsWhatHasComeIntoIt() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.Newest(4));
        hidden.add("berta1");
        feed.settle(clients);
        hidden.clear();
        hidden.add("annaa1");
        feed.settle(clients);
        feed.settle(clients);

        assertThat(heard(anna)).as("what waited is withheld").containsExactly("a");
        assertThat(heard(bert)).containsExactly("a1");
    }

    @Test
    void tellsEachChangeInOrderAndWhoSeesTheNewFormNoMoreThatItIsGone() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.EveryChange());
        hidden.add("berta2");
        feed.publish("a1");
        feed.publish("a1", "a2");
        feed.publish("a2", null);

        assertThat(heard(anna)).containsExactly("a1", "a2", "a");
        assertThat(heard(bert)).containsExactly("a1", "a");
    }

    @Test
    void saysNothingOfWhatIsGoneWhereATopicHasNothingToSay() {
        StreamTopicFeed<String> feed = feed(new StreamTopicRate.EveryChange(), null);
        feed.publish("a1");
        feed.publish("a1", null);
        feed.removed(A);
        feed.publishRemovals();

        assertThat(heard(anna)).containsExactly("a1");
    }
}
