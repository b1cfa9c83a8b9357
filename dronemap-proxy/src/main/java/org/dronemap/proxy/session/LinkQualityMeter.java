package org.dronemap.proxy.session;

import org.dronemap.core.drone.LinkQuality;
import org.jspecify.annotations.Nullable;

/** Computes a link's quality once a second from its message counts and round trip time. Owned by the drone's lane. */
public final class LinkQualityMeter {
    private static final long INTERVAL_NANOS = 1_000_000_000L;
    private static final double SHORT_SECONDS = 5;
    private static final double LONG_SECONDS = 60;

    private final PacketLossAverage shortLoss = new PacketLossAverage(SHORT_SECONDS);
    private final PacketLossAverage longLoss = new PacketLossAverage(LONG_SECONDS);
    private Counts taken = Counts.NONE;
    private long takenNanos;
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
    public boolean update(long nowNanos, Counts now, @Nullable Double roundTripMillis) {
        if (nowNanos - takenNanos < INTERVAL_NANOS) {
            return false;
        }
        double seconds = (nowNanos - takenNanos) / 1e9;
        shortLoss.add(now.received() - taken.received(), now.lost() - taken.lost(), seconds);
        longLoss.add(now.received() - taken.received(), now.lost() - taken.lost(), seconds);
        taken = now;
        takenNanos = nowNanos;
        LinkQuality before = quality;
        quality = new LinkQuality(shortLoss.share(), longLoss.share(), roundTripMillis);
        return !quality.equals(before);
    }

    public LinkQuality quality() {
        return quality;
    }
}
