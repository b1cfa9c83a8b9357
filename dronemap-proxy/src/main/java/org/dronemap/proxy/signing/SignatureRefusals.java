package org.dronemap.proxy.signing;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.dronemap.mavlink.signing.SignatureVerdict;

/**
 * Counts frames by signature verdict, and decides when refusals are worth a warning to the drone's users. Guarded by
 * its keyring.
 */
final class SignatureRefusals {
    private static final long SAY_AGAIN_NANOS = 600_000_000_000L;

    private final Map<SignatureVerdict, Long> counts = new EnumMap<>(SignatureVerdict.class);
    private final Map<SignatureVerdict, Long> lastRefusedNanos = new EnumMap<>(SignatureVerdict.class);

    void valid() {
        counts.merge(SignatureVerdict.VALID, 1L, Long::sum);
    }

    /** A sentence when such frames are news: the first, and the first after ten minutes without any. */
    Optional<String> refused(SignatureVerdict why, long nowNanos) {
        counts.merge(why, 1L, Long::sum);
        Long last = lastRefusedNanos.put(why, nowNanos);
        return last == null || nowNanos - last > SAY_AGAIN_NANOS ? Optional.of(sentence(why)) : Optional.empty();
    }

    private static String sentence(SignatureVerdict why) {
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

    SignatureCounts counts() {
        return new SignatureCounts(
                count(SignatureVerdict.VALID),
                count(SignatureVerdict.UNSIGNED),
                count(SignatureVerdict.BAD_SIGNATURE),
                count(SignatureVerdict.REPLAYED),
                count(SignatureVerdict.TOO_OLD),
                count(SignatureVerdict.TOO_MANY_STREAMS));
    }

    private long count(SignatureVerdict verdict) {
        return counts.getOrDefault(verdict, 0L);
    }
}
