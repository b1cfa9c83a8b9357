package org.dronemap.core.lease;

import java.time.Instant;

/**
 * The time for which one holder commands a drone.
 *
 * @param explicit asked for, and kept by heartbeats; else it came with a command and lasts until the holder is idle
 * @param heardNanos when the holder last gave a sign, monotonic
 */
public record Tenure(Holder holder, boolean explicit, Instant since, long heardNanos) {
    Tenure heard(Moment now) {
        return new Tenure(holder, explicit, since, now.nanos());
    }

    Tenure kept(Moment now) {
        return new Tenure(holder, true, since, now.nanos());
    }
}
