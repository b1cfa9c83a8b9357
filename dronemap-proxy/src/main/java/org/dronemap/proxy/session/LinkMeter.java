package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.RoundTrip;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;

/**
 * Measures the link of one vehicle: loss from what reached the socket (before any queue of ours), round trips from its
 * lane. Methods belong to the drone's lane, except {@link #arrived}.
 */
final class LinkMeter {
    private static final long INTERVAL_NANOS = 1_000_000_000L;
    private static final int MOST_COMPONENTS = 32;
    private static final double SHORT_SECONDS = 5;
    private static final double LONG_SECONDS = 60;

    /** What came since the start of the session. */
    record Counts(long received, long lost, long doubled) {
        private static final Counts NONE = new Counts(0, 0, 0);
    }

    // Owned by the endpoint's thread.
    private final Map<Integer, SequenceGaps> components = new HashMap<>();
    private volatile Counts counts = Counts.NONE;

    private final RoundTripProbe probe;
    private final LossAverage shortLoss = new LossAverage(SHORT_SECONDS);
    private final LossAverage longLoss = new LossAverage(LONG_SECONDS);
    private Counts taken = Counts.NONE;
    private long takenNanos;
    private LinkQuality quality = LinkQuality.UNKNOWN;

    LinkMeter(RoundTripProbe probe, long nowNanos) {
        this.probe = probe;
        takenNanos = nowNanos;
    }

    /** Any frame of the vehicle, as it leaves the socket; on the endpoint's thread. */
    void arrived(Frame frame, long nowNanos) {
        SequenceGaps gaps = components.get(frame.componentId());
        if (gaps == null) {
            if (!frame.verified() || components.size() == MOST_COMPONENTS) {
                return;
            }
            gaps = new SequenceGaps();
            components.put(frame.componentId(), gaps);
        }
        long receivedBefore = gaps.received();
        long lostBefore = gaps.lost();
        long doubledBefore = gaps.doubled();
        gaps.heard(frame.sequence(), nowNanos);
        Counts before = counts;
        counts = new Counts(
                before.received() + gaps.received() - receivedBefore,
                before.lost() + gaps.lost() - lostBefore,
                before.doubled() + gaps.doubled() - doubledBefore);
    }

    /** Any thread. */
    Counts counts() {
        return counts;
    }

    void heard(Frame frame, long nowNanos) {
        probe.heard(frame, nowNanos);
    }

    /** Asks for a round trip when that is due. */
    void ask(long nowNanos) {
        probe.tick(nowNanos);
    }

    /** True when the quality is worth telling: once an interval at most, and only news. */
    boolean tick(long nowNanos) {
        if (nowNanos - takenNanos < INTERVAL_NANOS) {
            return false;
        }
        Counts now = counts;
        double seconds = (nowNanos - takenNanos) / 1e9;
        shortLoss.add(now.received() - taken.received(), now.lost() - taken.lost(), seconds);
        longLoss.add(now.received() - taken.received(), now.lost() - taken.lost(), seconds);
        taken = now;
        takenNanos = nowNanos;
        LinkQuality before = quality;
        quality = new LinkQuality(
                shortLoss.share(), longLoss.share(), probe.roundTrip().smoothedMillis());
        return !quality.equals(before);
    }

    RoundTrip roundTrip() {
        return probe.roundTrip();
    }

    LinkQuality quality() {
        return quality;
    }
}
