package org.dronemap.core.lease;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A holder's control of a drone: explicit and kept by heartbeats, or implied by a command and ended when idle.
 *
 * @param explicit asked for, and kept by heartbeats; else it came with a command and lasts until the holder is idle
 * @param renewedNanos when the holder last gave a sign, monotonic
 * @param formerEpoch what the holder knows it by from before a restart; null: there was none
 */
public record Lease(
        LeaseHolder holder,
        boolean explicit,
        Instant since,
        long renewedNanos,
        @Nullable Long formerEpoch) {
    Lease renewed(ClockReading now) {
        return new Lease(holder, explicit, since, now.nanos(), formerEpoch);
    }

    Lease kept(ClockReading now) {
        return new Lease(holder, true, since, now.nanos(), formerEpoch);
    }
}
