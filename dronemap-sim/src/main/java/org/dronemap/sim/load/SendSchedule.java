package org.dronemap.sim.load;

import java.util.concurrent.locks.LockSupport;

/**
 * Load test: the open-loop schedule of all messages, evenly spread over the vehicles, in ns of the monotonic clock.
 * Vehicles take turns, evenly spread. Times are of the machine's monotonic clock in ns, which all its processes share.
 */
record SendSchedule(long startNanos, int vehicles, int perSecond) {
    private static final double SECOND_NANOS = 1e9;
    private static final long WORTH_SLEEPING_NANOS = 60_000;

    long dueNanos(int vehicle, long step) {
        return startNanos + (long) ((step * vehicles + vehicle) * SECOND_NANOS / ((double) vehicles * perSecond));
    }

    /** Returns when that time has come, or at once when it has passed. */
    static void await(long nanos) {
        for (long left = nanos - System.nanoTime(); left > 0; left = nanos - System.nanoTime()) {
            if (left > WORTH_SLEEPING_NANOS) {
                LockSupport.parkNanos(left - WORTH_SLEEPING_NANOS / 2);
            } else {
                Thread.onSpinWait();
            }
        }
    }
}
