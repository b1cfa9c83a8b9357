package org.dronemap.proxy.session;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Measures jitter as RFC 3550, section 6.4.1, does: by how much the times between two messages differ where they arrive
 * from where they were sent. Averaged over some 5 s and some 60 s, as loss is, rather than over 16 messages, so that
 * vehicles which speak seldom and often compare; and by the ratio at which both clocks go, as a simulator's may go
 * faster. Owned by the thread that receives.
 */
public final class JitterMeter {
    private static final double SHORT_SECONDS = 5;
    private static final double LONG_SECONDS = 60;
    private static final double LONGEST_GAP_SECONDS = 10;
    private static final double CLOCK_SECONDS = 30;
    /** As long as less was seen, it is not known how both clocks go. */
    private static final double CLOCK_KNOWN_SECONDS = 3;

    private static final int MOST_SERIES = 8;

    private final Map<Integer, Series> series = new LinkedHashMap<>();
    private final AgingMean shortMean = new AgingMean(SHORT_SECONDS);
    private final AgingMean longMean = new AgingMean(LONG_SECONDS);
    private double sentSum;
    private double arrivedSum;
    private long lastNanos;
    private volatile Jitter jitter = Jitter.UNKNOWN;

    /** Jitter in ms, over some 5 s and some 60 s; null while unknown. */
    public record Jitter(
            @Nullable Double shortMillis, @Nullable Double longMillis) {
        public static final Jitter UNKNOWN = new Jitter(null, null);
    }

    /** The newest message of one kind, whose times compare among themselves. */
    private static final class Series {
        private double sentSeconds;
        private long arrivedNanos;
    }

    /** {@code sentSeconds}: by the sender's clock, whatever that counts from. */
    public void arrived(int kind, double sentSeconds, long nowNanos) {
        Series of = series.get(kind);
        if (of == null) {
            if (series.size() < MOST_SERIES) {
                begin(kind, sentSeconds, nowNanos);
            }
            return;
        }
        double sent = sentSeconds - of.sentSeconds;
        double arrived = (nowNanos - of.arrivedNanos) / 1e9;
        if (sent <= 0 && sent > -LONGEST_GAP_SECONDS) {
            // A copy, or one that was overtaken.
            return;
        }
        of.sentSeconds = sentSeconds;
        of.arrivedNanos = nowNanos;
        if (sent <= 0 || arrived > LONGEST_GAP_SECONDS) {
            return;
        }
        measure(sent, arrived, nowNanos);
    }

    /** Of messages without a time, sent every {@code betweenSeconds}: lost ones between two are seen by the gap. */
    public void arrivedInTurn(int kind, double betweenSeconds, long nowNanos) {
        Series of = series.get(kind);
        if (of == null) {
            begin(kind, 0, nowNanos);
            return;
        }
        double turns = Math.max(1, Math.rint((nowNanos - of.arrivedNanos) / 1e9 / betweenSeconds));
        arrived(kind, of.sentSeconds + turns * betweenSeconds, nowNanos);
    }

    private void begin(int kind, double sentSeconds, long nowNanos) {
        Series of = new Series();
        of.sentSeconds = sentSeconds;
        of.arrivedNanos = nowNanos;
        series.put(kind, of);
        lastNanos = series.size() == 1 ? nowNanos : lastNanos;
    }

    private void measure(double sent, double arrived, long nowNanos) {
        double seconds = (nowNanos - lastNanos) / 1e9;
        lastNanos = nowNanos;
        double kept = Math.exp(-seconds / CLOCK_SECONDS);
        sentSum = sentSum * kept + sent;
        arrivedSum = arrivedSum * kept + arrived;
        if (arrivedSum < CLOCK_KNOWN_SECONDS) {
            return;
        }
        double off = Math.abs(arrived - sent * arrivedSum / sentSum) * 1_000;
        shortMean.add(off, seconds);
        longMean.add(off, seconds);
        jitter = new Jitter(shortMean.mean(), longMean.mean());
    }

    /** Any thread. */
    public Jitter jitter() {
        return jitter;
    }
}
