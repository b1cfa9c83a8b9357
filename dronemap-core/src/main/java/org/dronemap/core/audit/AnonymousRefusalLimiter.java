package org.dronemap.core.audit;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/**
 * Limits how many refused calls of unauthenticated callers get an audit record each; the others are only counted. The
 * others are counted, so that nobody can fill the disk from outside. Any thread.
 */
final class AnonymousRefusalLimiter {
    private static final long NANOS_EACH = TimeUnit.SECONDS.toNanos(1);

    private final long most;
    private final LongSupplier nanoTime;
    // guarded by this
    private long left;
    private long since;
    private long unrecorded;

    AnonymousRefusalLimiter(long most, LongSupplier nanoTime) {
        this.most = most;
        this.left = most;
        this.nanoTime = nanoTime;
        this.since = nanoTime.getAsLong();
    }

    synchronized boolean tryAcquire() {
        long more = (nanoTime.getAsLong() - since) / NANOS_EACH;
        if (more > 0) {
            left = Math.min(most, left + more);
            since += more * NANOS_EACH;
        }
        if (left == 0) {
            unrecorded++;
            return false;
        }
        left--;
        return true;
    }

    /** How many were not written down since this was last asked. */
    synchronized long drainUnrecorded() {
        long count = unrecorded;
        unrecorded = 0;
        return count;
    }
}
