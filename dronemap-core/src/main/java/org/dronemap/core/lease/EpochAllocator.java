package org.dronemap.core.lease;

import java.util.function.Consumer;

/**
 * Hands out control epochs, numbers that only rise, also over restarts; each new holder of a drone gets one. Shared by
 * all drones. Any thread; the store is asked ahead of need, in the background.
 */
public final class EpochAllocator {
    private static final int AT_ONCE = 100_000;

    private final LeaseStore store;
    private final Consumer<Runnable> background;
    // Guarded by this.
    private long last;
    private long limit;
    private long nextLimit;
    private boolean asked;

    /** {@code background} runs a task soon, on a thread that may wait for a disk. */
    public EpochAllocator(LeaseStore store, Consumer<Runnable> background) {
        this.store = store;
        this.background = background;
        limit = store.reserve(AT_ONCE);
        last = limit - AT_ONCE;
    }

    public synchronized long next() {
        if (last == limit) {
            limit = nextLimit > 0 ? nextLimit : store.reserve(AT_ONCE);
            last = limit - AT_ONCE;
            nextLimit = 0;
        }
        last++;
        if (nextLimit == 0 && !asked && limit - last < AT_ONCE / 2) {
            asked = true;
            background.accept(this::reserveMore);
        }
        return last;
    }

    private void reserveMore() {
        long reserved = 0;
        try {
            reserved = store.reserve(AT_ONCE);
        } finally {
            synchronized (this) {
                // One that was set aside at once meanwhile is in use already.
                nextLimit = reserved > limit ? reserved : nextLimit;
                asked = false;
            }
        }
    }
}
