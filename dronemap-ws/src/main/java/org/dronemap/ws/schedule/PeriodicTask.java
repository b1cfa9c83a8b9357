package org.dronemap.ws.schedule;

import java.time.Duration;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Runs a task at a fixed interval on a thread of its own, so that it may block. */
public final class PeriodicTask implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(PeriodicTask.class);

    private final Worker thread;
    private final Runnable what;
    private final String failure;

    /**
     * @param name of the thread
     * @param failure what is said in the log when a round failed; the next one comes all the same
     */
    public PeriodicTask(Time time, String name, Duration apart, Runnable what, String failure) {
        this.what = what;
        this.failure = failure;
        thread = time.worker(name, 1);
        var unused = thread.every(apart, apart, this::round);
    }

    private void round() {
        try {
            what.run();
        } catch (RuntimeException e) {
            LOG.error(failure, e);
        }
    }

    @Override
    public void close() {
        thread.close();
    }
}
