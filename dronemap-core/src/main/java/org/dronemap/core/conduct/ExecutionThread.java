package org.dronemap.core.conduct;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The single thread on which all changes of operations (or of virtual drones) are made, in order. */
final class ExecutionThread implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ExecutionThread.class);
    private static final int LONGEST_WAIT_SECONDS = 15;
    /** More than all that may be asked at once and every command that may end. */
    private static final int CAPACITY = 100_000;

    private final Time time;
    private final Worker thread;
    private volatile boolean closed;

    ExecutionThread(Time time, String name) {
        this.time = time;
        thread = time.worker(name, CAPACITY);
    }

    /** At once, and again after each such pause; a turn that fails is not the last one. */
    void every(Duration pause, Runnable work) {
        ScheduledTask begun = thread.every(Duration.ZERO, pause, work);
        LOG.debug("Conducting begins: {}", begun);
    }

    /** When its turn comes; not at all once this is closed. */
    void soon(Runnable work) {
        try {
            thread.execute(work);
        } catch (RejectedExecutionException e) {
            if (!closed) {
                LOG.error("The conductor has too much to do: something that happened is not heeded", e);
            }
        }
    }

    Duration busyFor() {
        return thread.busyFor();
    }

    /**
     * Waits for what comes of it.
     *
     * @throws IllegalStateException when that takes longer than {@value #LONGEST_WAIT_SECONDS} s: it may be done all the same
     */
    <T> T ask(Callable<T> work) {
        try {
            return time.await(thread.submit(AuditedCall.carried(work)), Duration.ofSeconds(LONGEST_WAIT_SECONDS));
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        } catch (TimeoutException e) {
            throw new IllegalStateException("The conductor does not answer; look again whether this was taken.", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Interrupted while waiting for the conductor.", e);
        }
    }

    @Override
    public void close() {
        closed = true;
        thread.close();
    }
}
