package org.dronemap.proxy.mavlink.procedure;

import java.util.Arrays;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Timesync;

/**
 * Measures the round trip time to a vehicle by TIMESYNC requests, rarely where they are never answered. Owned by the
 * session's lane.
 */
public final class RoundTripProbe {
    private static final long BETWEEN_NANOS = 2_000_000_000L;
    private static final long RARELY_NANOS = 30_000_000_000L;
    private static final long LONGEST_TRIP_NANOS = 20_000_000_000L;
    private static final long STALL_NANOS = 250_000_000L;
    private static final int VAIN_QUESTIONS = 5;
    private static final int MOST_OPEN = 16;

    private final MavlinkTarget target;
    private final RoundTripEstimator roundTrip;
    private final long[] open = new long[MOST_OPEN];
    private int asked;
    private int inVain;
    private long lastAskedNanos;
    private long lastTickNanos;

    public RoundTripProbe(MavlinkTarget target, RoundTripEstimator roundTrip) {
        this.target = target;
        this.roundTrip = roundTrip;
    }

    /** Any frame of the vehicle's autopilot. */
    public void received(Frame frame, long nowNanos) {
        if (frame.messageId() != Timesync.ID || frame.payloadLength() == 0) {
            return;
        }
        Timesync answer = Timesync.decode(frame);
        // Answers to other stations and to copies of a question carry a time that is not waited for (any more).
        if (answer.tc1() == 0 || answer.ts1() == 0 || !MavlinkTarget.isForUs(answer.targetSystem())) {
            return;
        }
        for (int i = 0; i < open.length; i++) {
            if (open[i] == answer.ts1()) {
                open[i] = 0;
                inVain = 0;
                long trip = nowNanos - answer.ts1();
                if (trip >= 0 && trip <= LONGEST_TRIP_NANOS) {
                    roundTrip.measured(trip);
                }
                return;
            }
        }
    }

    public void advance(long nowNanos) {
        if (nowNanos - lastTickNanos > STALL_NANOS) {
            // We stood still ourselves: what comes now has waited for us, not travelled.
            Arrays.fill(open, 0);
        }
        lastTickNanos = nowNanos;
        long pause = inVain > VAIN_QUESTIONS ? RARELY_NANOS : BETWEEN_NANOS;
        if (asked > 0 && nowNanos - lastAskedNanos < pause) {
            return;
        }
        lastAskedNanos = nowNanos;
        inVain++;
        open[asked++ % MOST_OPEN] = nowNanos;
        target.send(new Timesync(0, nowNanos, target.systemId(), target.componentId()));
    }

    public RoundTripEstimator roundTrip() {
        return roundTrip;
    }
}
