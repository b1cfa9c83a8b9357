package org.dronemap.proxy.session;

import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.link.LinkTrendEstimator;
import org.jspecify.annotations.Nullable;

/** Computes a link's quality and its trend once a second from message counts, round trip time and jitter. Owned by the drone's lane. */
public final class LinkQualityMeter {
    private static final long INTERVAL_NANOS = 1_000_000_000L;
    private static final double SHORT_SECONDS = 5;
    private static final double LONG_SECONDS = 60;

    private final PacketLossAverage shortLoss = new PacketLossAverage(SHORT_SECONDS);
    private final PacketLossAverage longLoss = new PacketLossAverage(LONG_SECONDS);
    private Counts taken = Counts.NONE;
    private long takenNanos;
    private final AgingMean longRoundTrip = new AgingMean(LONG_SECONDS);
    private final LinkTrendEstimator trend = new LinkTrendEstimator();
    private LinkQuality quality = LinkQuality.UNKNOWN;

    /** Messages since the link began: what came, what is missing, what came once more. */
    public record Counts(long received, long lost, long doubled) {
        public static final Counts NONE = new Counts(0, 0, 0);
    }

    public LinkQualityMeter(long nowNanos) {
        takenNanos = nowNanos;
    }

    /**
     * True when the quality is worth telling: once an interval at most, and only news.
     *
     * @param now all counts so far
     * @param roundTripMillis null: not known
     */
    public boolean update(long nowNanos, Counts now, @Nullable Double roundTripMillis, JitterMeter.Jitter jitter) {
        if (nowNanos - takenNanos < INTERVAL_NANOS) {
            return false;
        }
        double seconds = (nowNanos - takenNanos) / 1e9;
        long received = now.received() - taken.received();
        long lost = now.lost() - taken.lost();
        shortLoss.add(received, lost, seconds);
        longLoss.add(received, lost, seconds);
        if (roundTripMillis != null) {
            longRoundTrip.add(roundTripMillis, seconds);
        }
        taken = now;
        takenNanos = nowNanos;
        LinkQuality before = quality;
        LinkTrend trendBefore = trend.trend();
        quality = new LinkQuality(
                shortLoss.share(),
                longLoss.share(),
                roundTripMillis,
                longRoundTrip.mean(),
                jitter.shortMillis(),
                jitter.longMillis());
        return !trend.sample(quality, received, lost, seconds).equals(trendBefore) || !quality.equals(before);
    }

    /** Where the quality goes, compared with how this link usually is. */
    public LinkTrend trend() {
        return trend.trend();
    }

    public LinkQuality quality() {
        return quality;
    }
}
