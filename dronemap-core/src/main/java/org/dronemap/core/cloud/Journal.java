package org.dronemap.core.cloud;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.audit.Activity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One thread that writes to the store in order, so that no lane ever waits for a disk. Bounded; refusals are counted. */
public final class Journal implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);
    private static final int CAPACITY = 10_000;

    private final LongAdder failed = new LongAdder();
    private final ThreadPoolExecutor thread =
            new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new ArrayBlockingQueue<>(CAPACITY), task -> {
                Thread created = new Thread(task, "journal");
                created.setDaemon(true);
                return created;
            });

    /**
     * Runs {@code write} and then {@code after}, also when the write failed (which is logged and counted). The write is
     * part of the call that it is handed in for.
     */
    public void write(String what, Runnable write, Runnable after) {
        Runnable ofTheCall = Activity.carried(write);
        try {
            thread.execute(() -> {
                guard(what, ofTheCall);
                guard("what follows " + what, after);
            });
        } catch (RejectedExecutionException e) {
            failed.increment();
            LOG.error("The journal is full: {} was not written", what);
            after.run();
        }
    }

    /** Writes that failed or found no room since the start. */
    public long failedCount() {
        return failed.sum();
    }

    private void guard(String what, Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            failed.increment();
            LOG.error("{} failed", what, e);
        }
    }

    @Override
    public void close() {
        thread.shutdown();
        try {
            if (!thread.awaitTermination(5, TimeUnit.SECONDS)) {
                LOG.warn(
                        "The journal still had {} writes when it was closed",
                        thread.getQueue().size());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
