package org.dronemap.proxy.record;

import java.util.concurrent.atomic.AtomicLong;

/**
 * The limit on memory for recorded data that waits to be written to disk, shared by all recording buffers. Any thread.
 */
final class BufferBudget {
    private final AtomicLong free;

    public BufferBudget(long bytes) {
        free = new AtomicLong(bytes);
    }

    /** False, and nothing is taken, when there is not so much. */
    boolean tryAcquire(int bytes) {
        if (free.addAndGet(-bytes) >= 0) {
            return true;
        }
        free.addAndGet(bytes);
        return false;
    }

    void release(int bytes) {
        free.addAndGet(bytes);
    }
}
