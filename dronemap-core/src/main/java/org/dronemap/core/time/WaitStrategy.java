package org.dronemap.core.time;

import java.util.concurrent.locks.LockSupport;

/**
 * Chooses how a thread waits for work: blocks while work is rare, polls each millisecond while it is frequent. Owned by
 * that thread.
 */
public final class WaitStrategy {
    /** Who is woken so soon is in a hurry. */
    private static final long SOON_NANOS = 500_000L;

    private static final long REST_NANOS = 1_000_000L;

    private boolean hurried;

    /**
     * Blocks until there may be work, or until its own patience ends.
     *
     * @param <E> what it fails with
     */
    public interface Wait<E extends Exception> {
        void untilWork() throws E;
    }

    /** Returns when it is time to look for work; {@code found}: the look before found some, and did all of it. */
    public <E extends Exception> void pause(boolean found, Wait<E> wait) throws E {
        if (found && hurried) {
            LockSupport.parkNanos(this, REST_NANOS);
            return;
        }
        long began = System.nanoTime();
        wait.untilWork();
        hurried = System.nanoTime() - began < SOON_NANOS;
    }
}
