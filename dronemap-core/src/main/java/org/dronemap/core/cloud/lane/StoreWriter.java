package org.dronemap.core.cloud.lane;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.TransientFailure;
import org.dronemap.core.time.Worker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A thread that runs writes to the store in order, so that no lane waits for a disk. Bounded; refusals are counted. */
public final class StoreWriter implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(StoreWriter.class);
    private static final int CAPACITY = 10_000;
    private static final Duration LONGEST_FINISH = Duration.ofSeconds(5);

    private final LongAdder failed = new LongAdder();
    private final Worker thread;

    public StoreWriter(Time time) {
        thread = time.worker("journal", CAPACITY);
    }

    /**
     * Runs {@code write} and then {@code after}, also when the write failed (which is logged and counted). The write is
     * part of the call that it is handed in for.
     */
    public void write(String what, Runnable write, Runnable after) {
        Runnable ofTheCall = AuditedCall.carried(write);
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

    /** The same for who waits: ends when it is written, or with why it is not. */
    public CompletableFuture<Void> written(String what, Runnable write) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        write(
                what,
                () -> {
                    try {
                        write.run();
                        done.complete(null);
                    } catch (RuntimeException e) {
                        done.completeExceptionally(e);
                        throw e;
                    }
                },
                () -> done.completeExceptionally(new Full(what)));
        return done;
    }

    /** More waits to be written than there is room for. */
    private static final class Full extends RuntimeException implements TransientFailure {
        private static final long serialVersionUID = 1L;

        Full(String what) {
            super("The journal is full: " + what + " was not written");
        }

        @Override
        public boolean isTransient() {
            return true;
        }
    }

    /** Writes that failed or found no room since the start. */
    public long failedCount() {
        return failed.sum();
    }

    /** For how long it has been at the same write; zero: none is under way. */
    public Duration busyFor() {
        return thread.busyFor();
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
        if (!thread.finish(LONGEST_FINISH)) {
            LOG.warn("The journal still had {} writes when it was closed", thread.waiting());
        }
    }
}
