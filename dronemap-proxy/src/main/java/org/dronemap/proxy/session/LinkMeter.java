package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.proxy.mavlink.procedure.RoundTripEstimator;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;

/**
 * Measures one MAVLink link of a vehicle: message loss, round trip time and jitter. Methods belong to the drone's lane, except
 * {@link #arrived}.
 */
final class LinkMeter {
    private static final int MOST_COMPONENTS = 32;
    private static final double SECONDS_OF_MILLI = 1e-3;

    // Owned by the endpoint's thread.
    private final Map<Integer, SequenceGaps> components = new HashMap<>();
    private final JitterMeter jitter = new JitterMeter();
    private volatile LinkQualityMeter.Counts counts = LinkQualityMeter.Counts.NONE;

    private final RoundTripProbe probe;
    private final LinkQualityMeter loss;

    LinkMeter(RoundTripProbe probe, long nowNanos) {
        this.probe = probe;
        loss = new LinkQualityMeter(nowNanos);
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
        timed(frame, nowNanos);
        long receivedBefore = gaps.received();
        long lostBefore = gaps.lost();
        long doubledBefore = gaps.doubled();
        gaps.count(frame.sequence(), nowNanos);
        LinkQualityMeter.Counts before = counts;
        counts = new LinkQualityMeter.Counts(
                before.received() + gaps.received() - receivedBefore,
                before.lost() + gaps.lost() - lostBefore,
                before.doubled() + gaps.doubled() - doubledBefore);
    }

    /** Messages that are sent all the time and begin with when they were made, in ms since the vehicle began. */
    private void timed(Frame frame, long nowNanos) {
        boolean tells = switch (frame.messageId()) {
            case Attitude.ID, GlobalPositionInt.ID -> frame.verified();
            default -> false;
        };
        if (tells) {
            int kind = frame.componentId() << 24 | frame.messageId();
            jitter.arrived(kind, frame.u32(0) * SECONDS_OF_MILLI, nowNanos);
        }
    }

    /** Any thread. */
    LinkQualityMeter.Counts counts() {
        return counts;
    }

    void received(Frame frame, long nowNanos) {
        probe.received(frame, nowNanos);
    }

    /** Asks for a round trip when that is due. */
    void ask(long nowNanos) {
        probe.advance(nowNanos);
    }

    /** True when the quality is worth telling: once an interval at most, and only news. */
    boolean advance(long nowNanos) {
        return loss.update(nowNanos, counts, probe.roundTrip().smoothedMillis(), jitter.jitter());
    }

    RoundTripEstimator roundTrip() {
        return probe.roundTrip();
    }

    LinkQuality quality() {
        return loss.quality();
    }

    LinkTrend trend() {
        return loss.trend();
    }
}
