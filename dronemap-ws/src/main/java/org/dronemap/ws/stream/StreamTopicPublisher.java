package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.List;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.stream.delivery.PublishLoop;

/**
 * Runs the feeds of all stream topics, and sends each client what it may see. Owned by the pump, but for what its
 * topics hear.
 */
final class StreamTopicPublisher {
    private static final PublishLoop.Pause NOBODY_LISTENS = new PublishLoop.Pause(5_000_000L, 40_000_000L);

    private final GrantRegistry grants;
    private final Collection<StreamClient> clients;
    private final List<StreamTopicFeed<?>> feeds;
    private long edition;

    /** {@code wake} asks for a round of the pump. */
    StreamTopicPublisher(
            List<StreamTopic<?>> topics,
            GrantRegistry grants,
            JsonCodec json,
            StreamClientRegistry crowd,
            Runnable wake) {
        this.grants = grants;
        this.clients = crowd.clients();
        Runnable wakeForSomebody = () -> {
            if (!clients.isEmpty()) {
                wake.run();
            }
        };
        this.feeds = topics.stream()
                .<StreamTopicFeed<?>>map(topic -> new StreamTopicFeed<>(topic, json, clients, wakeForSomebody))
                .toList();
    }

    /** From now on all that happens is told. */
    void listen() {
        feeds.forEach(StreamTopicFeed::listen);
    }

    /** A round of the pump: hands out what is due, and says when to come again. */
    PublishLoop.Pause publish(long nowNanos) {
        feeds.forEach(StreamTopicFeed::publishRemovals);
        settle();
        PublishLoop.Pause pause = PublishLoop.Pause.ANY;
        for (StreamTopicFeed<?> feed : feeds) {
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
