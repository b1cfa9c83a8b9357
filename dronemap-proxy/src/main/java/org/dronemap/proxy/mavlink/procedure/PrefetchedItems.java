package org.dronemap.proxy.mavlink.procedure;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;

/** The mission items that a download requested ahead of their turn, and those that arrived early. */
final class PrefetchedItems {
    private final Map<Integer, Long> askedNanos = new HashMap<>();
    private final Map<Integer, MissionItemInt> early = new HashMap<>();

    void asked(int seq, long nowNanos) {
        askedNanos.put(seq, nowNanos);
    }

    /** When it was asked for last; null: never. */
    @Nullable
    Long askedNanos(int seq) {
        return askedNanos.get(seq);
    }

    /** It has not come, and was not asked for, or so long ago that the question or the answer is lost. */
    boolean isWanted(int seq, long nowNanos, long pauseNanos) {
        Long asked = askedNanos.get(seq);
        return !early.containsKey(seq) && (asked == null || nowNanos - asked >= pauseNanos);
    }

    /** False for one that nobody asked for. */
    boolean keep(MissionItemInt item) {
        boolean asked = askedNanos.containsKey(item.seq());
        if (asked) {
            early.put(item.seq(), item);
        }
        return asked;
    }

    @Nullable
    MissionItemInt remove(int seq) {
        return early.remove(seq);
    }

    void forget() {
        askedNanos.clear();
        early.clear();
    }
}
