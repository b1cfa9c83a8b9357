package org.dronemap.core.time;

import java.time.Duration;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A {@link Worker} on a real thread of its own. */
final class RealTimeWorker implements Worker {
    private static final Logger LOG = LoggerFactory.getLogger(RealTimeWorker.class);

    private final String name;
    private final int capacity;
    private final AtomicInteger waiting = new AtomicInteger();
    private volatile @Nullable Long begunNanos;
    private final ScheduledThreadPoolExecutor thread;

    RealTimeWorker(String name, int capacity) {
        this.name = name;
        this.capacity = capacity;
        thread = new ScheduledThreadPoolExecutor(1, work -> RealTime.onDuty(name, work));
        thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
        thread.setContinueExistingPeriodicTasksAfterShutdownPolicy(false);
        thread.setRemoveOnCancelPolicy(true);
        // Who has no thread learns it now, and not with the first thing to do.
        thread.prestartAllCoreThreads();
    }

    @Override
    public void execute(Runnable work) {
        if (waiting.incrementAndGet() > capacity) {
            waiting.decrementAndGet();
            throw new RejectedExecutionException(name + " has " + capacity + " things to do already");
        }
        boolean taken = false;
        try {
            thread.execute(() -> {
                waiting.decrementAndGet();
                guarded(work);
            });
            taken = true;
        } finally {
            if (!taken) {
                waiting.decrementAndGet();
            }
        }
    }

    @Override
    public ScheduledTask after(Duration pause, Runnable work) {
        return begun(() -> thread.schedule(() -> guarded(work), pause.toNanos(), TimeUnit.NANOSECONDS));
    }

    @Override
    public ScheduledTask every(Duration first, Duration pause, Runnable work) {
        return begun(() -> thread.scheduleWithFixedDelay(
                () -> guarded(work), first.toNanos(), pause.toNanos(), TimeUnit.NANOSECONDS));
    }

    /** A way to begin something that is due later. */
    private interface Beginning {
        ScheduledFuture<?> begin();
    }

    private ScheduledTask begun(Beginning beginning) {
        try {
            ScheduledFuture<?> due = beginning.begin();
            return () -> due.cancel(false);
        } catch (RejectedExecutionException e) {
            LOG.debug("{} is closed", name);
            return () -> {};
        }
    }

    private void guarded(Runnable work) {
        begunNanos = System.nanoTime();
        try {
            work.run();
        } catch (RuntimeException e) {
            LOG.error("{} failed at one thing; it goes on with the next", name, e);
        } catch (Error e) {
            // The executor would keep it to itself.
            FatalErrors.report(e);
            throw e;
        } finally {
            begunNanos = null;
        }
    }

    @Override
    public Duration busyFor() {
        Long begun = begunNanos;
        return begun == null ? Duration.ZERO : Duration.ofNanos(System.nanoTime() - begun);
    }

    @Override
    public int waiting() {
        return waiting.get();
    }

    @Override
    public boolean finish(Duration longest) {
        thread.shutdown();
        try {
            return thread.awaitTermination(longest.toNanos(), TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
