package org.dronemap.ws.wiring;

import java.time.Duration;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Does the same over and over, so long apart; on a thread of its own, for what is done may wait for the store or others. */
final class Rounds implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Rounds.class);

    private final ScheduledExecutorService thread;
    private final ScheduledFuture<?> rounds;
    private final Runnable what;
    private final String failure;

    /**
     * @param name of the thread
     * @param failure what is said in the log when a round failed; the next one comes all the same
     */
    Rounds(String name, Duration apart, Runnable what, String failure) {
        this.what = what;
        this.failure = failure;
        thread = Executors.newSingleThreadScheduledExecutor(task -> {
            Thread created = new Thread(task, name);
            created.setDaemon(true);
            return created;
        });
        rounds = thread.scheduleWithFixedDelay(this::round, apart.toMillis(), apart.toMillis(), TimeUnit.MILLISECONDS);
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
        rounds.cancel(false);
        thread.shutdown();
    }
}
