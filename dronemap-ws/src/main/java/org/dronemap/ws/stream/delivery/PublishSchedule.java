package org.dronemap.ws.stream.delivery;

import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Decides when the newest state of each thing is sent to stream clients; less often for larger fleets. Small fleets are
 * shown as fast as they report, big ones five times a second. Owned by the pump.
 *
 * @param <P> a picture
 */
public final class PublishSchedule<P> {
    public static final int MOST_PER_SECOND = 50;
    private static final long SHORTEST_GAP_NANOS = 1_000_000_000L / MOST_PER_SECOND;
    private static final long LONGEST_GAP_NANOS = 200_000_000L;
    /** Up to 1,250 pictures a second for all of a topic together. */
    private static final long SHARE_NANOS = 800_000L;

    private static final long FORGOTTEN_NANOS = 60_000_000_000L;

    private final long askedGapNanos;
    private final Map<StreamMessageSubject, P> waiting = new LinkedHashMap<>();
    private final Map<StreamMessageSubject, Long> sentNanos = new HashMap<>();

    /** {@code perSecond}: not more than this of each thing. */
    public PublishSchedule(int perSecond) {
        askedGapNanos = 1_000_000_000L / perSecond;
    }

    public void changed(StreamMessageSubject id, P picture) {
        waiting.put(id, picture);
    }

    /** The same, and its turn is now, whenever its last one was. */
    public void changedAtOnce(StreamMessageSubject id, P picture) {
        sentNanos.remove(id);
        changed(id, picture);
    }

    public void removed(StreamMessageSubject id) {
        waiting.remove(id);
        sentNanos.remove(id);
    }

    public long gapNanos() {
        long fair = Math.min(LONGEST_GAP_NANOS, sentNanos.size() * SHARE_NANOS);
        return Math.max(askedGapNanos, Math.max(SHORTEST_GAP_NANOS, fair));
    }

    /** Hands out all whose turn has come; in how many ns the next one's does, at most a gap. */
    public long publishDue(long nowNanos, Consumer<P> due) {
        long gap = gapNanos();
        long next = gap;
        for (Iterator<Map.Entry<StreamMessageSubject, P>> pictures =
                        waiting.entrySet().iterator();
                pictures.hasNext(); ) {
            Map.Entry<StreamMessageSubject, P> picture = pictures.next();
            Long sent = sentNanos.get(picture.getKey());
            long left = sent == null ? 0 : sent + gap - nowNanos;
            if (left > 0) {
                next = Math.min(next, left);
            } else {
                pictures.remove();
                sentNanos.put(picture.getKey(), nowNanos);
                due.accept(picture.getValue());
            }
        }
        return next;
    }

    /** What did not change for long takes no share. */
    public void forget(long nowNanos) {
        sentNanos.values().removeIf(sent -> nowNanos - sent > FORGOTTEN_NANOS);
    }
}
