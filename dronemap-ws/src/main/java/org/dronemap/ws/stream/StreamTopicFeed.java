package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.stream.delivery.PublishLoop;
import org.dronemap.ws.stream.delivery.PublishSchedule;
import org.dronemap.ws.stream.delivery.StreamMessageSubject;
import org.dronemap.ws.stream.delivery.StreamTopicSink;
import org.jspecify.annotations.Nullable;

/**
 * Sends the updates of one stream topic to the clients of the WebSocket stream. Of what changes often the newest state
 * alone waits here, one of each thing, until its turn. {@link #publish}, {@link #changed} and {@link #removed} from any
 * thread, the rest from the pump alone.
 */
final class StreamTopicFeed<T> implements StreamTopicSink<T> {
    private static final long SHORTEST_REST_NANOS = 500_000L;
    private static final long RESTS_IN_A_GAP = 20;

    private final StreamTopic<T> topic;
    private final JsonCodec json;
    private final Collection<StreamClient> clients;
    private final Runnable wake;
    private final ConcurrentHashMap<StreamMessageSubject, PendingUpdate<T>> changed = new ConcurrentHashMap<>();
    private final Queue<StreamMessageSubject> removed = new ConcurrentLinkedQueue<>();
    // Owned by the pump: by how many pictures a second clients want at most.
    private final Map<Integer, PublishSchedule<Supplier<Optional<T>>>> turns = new HashMap<>();

    /** {@code thing}: as it is when its turn comes; {@code atOnce}: that is now, whenever its last one was. */
    private record PendingUpdate<T>(Supplier<Optional<T>> thing, boolean atOnce) {
        PendingUpdate<T> before(PendingUpdate<T> later) {
            return atOnce && !later.atOnce() ? new PendingUpdate<>(later.thing(), true) : later;
        }
    }

    /** {@code clients}: as they come and go; {@code wake} asks for a round of the pump. */
    StreamTopicFeed(StreamTopic<T> topic, JsonCodec json, Collection<StreamClient> clients, Runnable wake) {
        this.topic = topic;
        this.json = json;
        this.clients = clients;
        this.wake = wake;
    }

    void listen() {
        topic.source().accept(this);
    }

    @Override
    public void publish(T now) {
        publish(null, now);
    }

    @Override
    public void publish(@Nullable T former, @Nullable T now) {
        Map<Object, String> written = new HashMap<>();
        for (StreamClient client : clients) {
            Principal who = client.listener().orElse(null);
            if (who != null
                    && !publish(client, who, now, written)
                    && former != null
                    && isWithdrawn()
                    && sight(client, who, topic.about().subject(former), former) != null) {
                client.outbox().add(removal(topic.about().subject(former)));
            }
        }
    }

    private boolean publish(StreamClient client, Principal who, @Nullable T now, Map<Object, String> written) {
        StreamMessageSubject subject = now == null ? null : topic.about().subject(now);
        Object sight = now == null || subject == null ? null : sight(client, who, subject, now);
        if (now == null || sight == null) {
            return false;
        }
        client.outbox().add(subject, written.computeIfAbsent(sight, unused -> picture(now, who)));
        return true;
    }

    @Override
    public void changed(String id, Supplier<Optional<T>> thing) {
        changed.merge(topic.about().subject(id), new PendingUpdate<>(thing, false), PendingUpdate::before);
        wake.run();
    }

    @Override
    public void changedAtOnce(String id, Supplier<Optional<T>> thing) {
        changed.put(topic.about().subject(id), new PendingUpdate<>(thing, true));
        wake.run();
    }

    @Override
    public void removed(String id) {
        removed.add(topic.about().subject(id));
        wake.run();
    }

    /** In the pump's own order, so that no picture follows the farewell. */
    void publishRemovals() {
        for (StreamMessageSubject gone = removed.poll(); gone != null; gone = removed.poll()) {
            StreamMessageSubject subject = gone;
            changed.remove(subject);
            turns.values().forEach(each -> each.removed(subject));
            for (StreamClient client : clients) {
                client.outbox().forget(subject);
                if (client.shown().remove(subject) != null) {
                    client.outbox().add(removal(subject));
                }
            }
        }
    }

    /** Whether clients are told when a thing is out of sight. */
    boolean isWithdrawn() {
        return topic.isWithdrawn();
    }

    /**
     * Shows clients what they see and were not shown so, and takes from them what they see no longer. What is not taken back
     * is shown again.
     */
    void settle(Collection<StreamClient> some) {
        if (some.isEmpty()) {
            return;
        }
        for (T thing : topic.atFirst().get()) {
            for (StreamClient client : some) {
                client.listener().ifPresent(who -> settle(client, who, thing));
            }
        }
    }

    private void settle(StreamClient client, Principal who, T thing) {
        StreamMessageSubject subject = topic.about().subject(thing);
        Object sight = topic.audience().sight().of(who, thing);
        Object before = client.shown().get(subject);
        if (sight != null && !sight.equals(before)) {
            show(List.of(client), thing);
        } else if (sight == null && before != null) {
            client.shown().remove(subject);
            client.outbox().withhold(subject);
            client.outbox().add(removal(subject));
        }
    }

    /** Hands out what is due, and says when to come again: not too often, so that much news costs no more than some. */
    PublishLoop.Pause publish(long nowNanos) {
        Map<Integer, Collection<StreamClient>> groups = topic.rate().groups(clients);
        turns.keySet().retainAll(groups.keySet());
        groups.keySet().forEach(rate -> turns.computeIfAbsent(rate, PublishSchedule::new));
        changed.forEach(this::queue);
        PublishLoop.Pause pause = PublishLoop.Pause.ANY;
        for (Map.Entry<Integer, PublishSchedule<Supplier<Optional<T>>>> entry : turns.entrySet()) {
            PublishSchedule<Supplier<Optional<T>>> each = entry.getValue();
            Collection<StreamClient> group = groups.getOrDefault(entry.getKey(), List.of());
            each.forget(nowNanos);
            long next = each.publishDue(nowNanos, thing -> thing.get().ifPresent(now -> show(group, now)));
            pause = pause.and(new PublishLoop.Pause(
                    Math.max(SHORTEST_REST_NANOS, each.gapNanos() / RESTS_IN_A_GAP),
                    Math.max(SHORTEST_REST_NANOS, next)));
        }
        return pause;
    }

    private void queue(StreamMessageSubject subject, PendingUpdate<T> news) {
        // What is newer and came in meanwhile stays for the next round.
        if (changed.remove(subject, news)) {
            turns.values().forEach(each -> {
                if (news.atOnce()) {
                    each.changedAtOnce(subject, news.thing());
                } else {
                    each.changed(subject, news.thing());
                }
            });
        }
    }

    private void show(Collection<StreamClient> some, T thing) {
        StreamMessageSubject subject = topic.about().subject(thing);
        Map<Object, String> written = new HashMap<>();
        for (StreamClient client : some) {
            Principal who = client.listener().orElse(null);
            Object sight = who == null ? null : sight(client, who, subject, thing);
            if (who == null || sight == null) {
                continue;
            }
            if (isWithdrawn()) {
                client.shown().put(subject, sight);
            }
            client.outbox().offer(subject, written.computeIfAbsent(sight, unused -> picture(thing, who)));
        }
    }

    private @Nullable Object sight(StreamClient client, Principal who, StreamMessageSubject subject, T thing) {
        return client.wants(subject) ? topic.audience().sight().of(who, thing) : null;
    }

    private String picture(T thing, Principal who) {
        return json.write(topic.picture().apply(thing, who));
    }

    private String removal(StreamMessageSubject subject) {
        return json.write(Objects.requireNonNull(topic.removal()).of().apply(subject.id()));
    }
}
