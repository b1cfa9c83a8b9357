package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.List;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.ws.reading.JsonReader;
import org.dronemap.ws.stream.delivery.PublishLoop;

/**
 * Runs the feeds of all stream topics, and sends each client what it may see. Owned by the pump, but for what its
 * topics hear.
 */
final class TopicPublisher {
    private static final PublishLoop.Pause NOBODY_LISTENS = new PublishLoop.Pause(5_000_000L, 40_000_000L);

    private final GrantRegistry grants;
    private final Collection<StreamClient> clients;
    private final List<TopicFeed<?>> feeds;
    private long edition;

    /** {@code wake} asks for a round of the pump. */
    TopicPublisher(
            List<Topic<?>> topics, GrantRegistry grants, JsonReader json, StreamClientRegistry crowd, Runnable wake) {
        this.grants = grants;
        this.clients = crowd.clients();
        Runnable wakeForSomebody = () -> {
            if (!clients.isEmpty()) {
                wake.run();
            }
        };
        this.feeds = topics.stream()
                .<TopicFeed<?>>map(topic -> new TopicFeed<>(topic, json, clients, wakeForSomebody))
                .toList();
    }

    /** From now on all that happens is told. */
    void listen() {
        feeds.forEach(TopicFeed::listen);
    }

    /** A round of the pump: hands out what is due, and says when to come again. */
    PublishLoop.Pause publish(long nowNanos) {
        feeds.forEach(TopicFeed::publishRemovals);
        settle();
        PublishLoop.Pause pause = PublishLoop.Pause.ANY;
        for (TopicFeed<?> feed : feeds) {
            pause = pause.and(feed.publish(nowNanos));
        }
        return pause.equals(PublishLoop.Pause.ANY) ? NOBODY_LISTENS : pause;
    }

    /** When clients have come in, and when grants were changed, have begun or have ended. */
    private void settle() {
        long now = grants.edition();
        boolean changed = now != edition;
        edition = now;
        List<StreamClient> arrived =
                clients.stream().filter(StreamClient::settle).toList();
        feeds.forEach(feed -> feed.settle(changed && feed.isWithdrawn() ? clients : arrived));
    }
}
