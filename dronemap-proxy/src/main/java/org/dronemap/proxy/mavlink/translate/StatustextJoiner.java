package org.dronemap.proxy.mavlink.translate;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BiConsumer;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Statustext;

/**
 * Joins the chunks of long STATUSTEXT messages of a vehicle's components into whole sentences. Each component numbers
 * its sentences by itself, and anew with each boot. Owned by the drone's lane.
 */
final class StatustextJoiner {
    private static final long PATIENCE_NANOS = 1_000_000_000L;
    private static final int MOST_OPEN = 32;

    private final BiConsumer<Severity, String> out;
    private final Map<Key, StatustextChunks> open = new LinkedHashMap<>();

    private record Key(int component, int id) {}

    StatustextJoiner(BiConsumer<Severity, String> out) {
        this.out = out;
    }

    void received(Frame frame, long nowNanos) {
        Statustext message = Statustext.decode(frame);
        Severity severity = severity(message.severity());
        if (message.id() == 0) {
            publish(severity, message.text());
            return;
        }
        Key key = new Key(frame.componentId(), message.id());
        StatustextChunks chunks = open.get(key);
        if (chunks != null && (isOver(chunks, nowNanos) || !chunks.accepts(frame))) {
            open.remove(key);
            publish(chunks);
            chunks = null;
        }
        if (chunks == null) {
            makeRoom();
            chunks = new StatustextChunks(severity, message.severity());
            open.put(key, chunks);
        }
        chunks.add(frame, nowNanos);
        if (chunks.isComplete() || chunks.isLong()) {
            publish(chunks);
        }
    }

    /** Lets go of sentences whose end does not come, and forgets the numbers of those that were told. */
    void advance(long nowNanos) {
        for (Iterator<StatustextChunks> all = open.values().iterator(); all.hasNext(); ) {
            StatustextChunks chunks = all.next();
            if (isOver(chunks, nowNanos)) {
                all.remove();
                publish(chunks);
            }
        }
    }

    private static boolean isOver(StatustextChunks chunks, long nowNanos) {
        return nowNanos - chunks.lastNanos() > PATIENCE_NANOS;
    }

    private void makeRoom() {
        if (open.size() == MOST_OPEN) {
            Iterator<StatustextChunks> all = open.values().iterator();
            StatustextChunks oldest = all.next();
            all.remove();
            publish(oldest);
        }
    }

    private void publish(StatustextChunks chunks) {
        chunks.textOnce().ifPresent(text -> publish(chunks.severity(), text));
    }

    private void publish(Severity how, String text) {
        if (!text.isBlank()) {
            out.accept(how, text.strip());
        }
    }

    private static Severity severity(int number) {
        Severity[] all = Severity.values();
        return number < all.length ? all[number] : Severity.INFO;
    }
}
