package org.dronemap.proxy.mavlink.procedure;

import java.util.HashMap;
import java.util.Map;

/**
 * Times when each MAV_CMD last went to or was acknowledged by a vehicle, to match an acknowledgement with its command.
 * An acknowledgement names only the command, not which copy of it: one that comes too soon after an earlier exchange
 * may still belong to that. Owned by the drone's lane.
 */
public final class CommandSendTimes {
    private final Map<Integer, Long> lastSeenNanos = new HashMap<>();

    /** A copy went out, or an acknowledgement came in. */
    void crossed(int command, long nowNanos) {
        lastSeenNanos.put(command, nowNanos);
    }

    /** From then on an acknowledgement can only be that of a newer exchange. */
    long settledNanos(int command, long nowNanos, RoundTripEstimator roundTrip) {
        Long last = lastSeenNanos.get(command);
        return last == null ? nowNanos : last + roundTrip.timeoutNanos();
    }
}
