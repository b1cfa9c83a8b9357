package org.dronemap.core.conduct;

import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.audit.Activity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The one thread that owns what is conducted: all changes happen on it, one after the other. */
final class ConductorThread implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ConductorThread.class);
    private static final int LONGEST_WAIT_SECONDS = 15;

    private final ScheduledExecutorService thread;

    ConductorThread(String name) {
        thread = Executors.newSingleThreadScheduledExecutor(task -> {
            Thread created = new Thread(task, name);
            created.setDaemon(true);
            return created;
        });
    }

    /** At once, and again after each such pause; a turn that fails is not the last one. */
    void every(long pause, TimeUnit unit, Runnable work) {
        ScheduledFuture<?> begun = thread.scheduleWithFixedDelay(() -> tried(work), 0, pause, unit);
        LOG.debug("Conducting begins: {}", begun);
    }

    private static void tried(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            LOG.error("A turn of the conductor failed; the next one is tried", e);
        }
    }

    /** When its turn comes; not at all once this is closed. */
    void soon(Runnable work) {
        try {
            thread.execute(work);
        } catch (RejectedExecutionException e) {
            LOG.debug("The conductor has stopped");
        }
    }

    /**
     * Waits for what comes of it.
     *
     * @throws IllegalStateException when that takes longer than {@value #LONGEST_WAIT_SECONDS} s: it may be done all the same
     */
    <T> T ask(Callable<T> work) {
        try {
            return thread.submit(Activity.carried(work)).get(LONGEST_WAIT_SECONDS, TimeUnit.SECONDS);
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
        thread.shutdownNow();
    }
}
