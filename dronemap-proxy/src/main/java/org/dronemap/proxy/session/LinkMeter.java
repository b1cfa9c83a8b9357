package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.RoundTripEstimator;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;

/**
 * Measures one MAVLink link of a vehicle: message loss and round trip time. Methods belong to the drone's lane, except
 * {@link #arrived}.
 */
final class LinkMeter {
    private static final int MOST_COMPONENTS = 32;

    // Owned by the endpoint's thread.
    private final Map<Integer, SequenceGaps> components = new HashMap<>();
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
        return loss.update(nowNanos, counts, probe.roundTrip().smoothedMillis());
    }

    RoundTripEstimator roundTrip() {
        return probe.roundTrip();
    }

    LinkQuality quality() {
        return loss.quality();
    }
}
