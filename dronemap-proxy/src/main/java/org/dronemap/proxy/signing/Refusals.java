package org.dronemap.proxy.signing;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.dronemap.mavlink.signing.Verdict;

/** Counts how frames were judged and decides when that is worth a sentence. Guarded by its keyring. */
final class Refusals {
    private static final long SAY_AGAIN_NANOS = 600_000_000_000L;

    private final Map<Verdict, Long> counts = new EnumMap<>(Verdict.class);
    private final Map<Verdict, Long> lastHeardNanos = new EnumMap<>(Verdict.class);

    void valid() {
        counts.merge(Verdict.VALID, 1L, Long::sum);
    }

    /** A sentence when such frames are news: the first, and the first after ten minutes without any. */
    Optional<String> refused(Verdict why, long nowNanos) {
        counts.merge(why, 1L, Long::sum);
        Long last = lastHeardNanos.put(why, nowNanos);
        return last == null || nowNanos - last > SAY_AGAIN_NANOS ? Optional.of(sentence(why)) : Optional.empty();
    }

    private static String sentence(Verdict why) {
        String what = switch (why) {
            case VALID -> throw new IllegalArgumentException("a valid frame is not refused");
            case UNSIGNED -> "Unsigned messages";
            case BAD_SIGNATURE -> "Messages signed with another key";
            case REPLAYED -> "Messages that were sent before";
            case TOO_OLD -> "Signed messages with a time long past";
            case TOO_MANY_STREAMS -> "Signed messages of more senders than one vehicle has";
        };
        return what + " came in this drone's name; they are refused and counted.";
    }

    FrameCounts counts() {
        return new FrameCounts(
                count(Verdict.VALID),
                count(Verdict.UNSIGNED),
                count(Verdict.BAD_SIGNATURE),
                count(Verdict.REPLAYED),
                count(Verdict.TOO_OLD),
                count(Verdict.TOO_MANY_STREAMS));
    }

    private long count(Verdict verdict) {
        return counts.getOrDefault(verdict, 0L);
    }
}
