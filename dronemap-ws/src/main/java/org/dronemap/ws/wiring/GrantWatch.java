package org.dronemap.ws.wiring;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.access.GrantBook;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Looks five times a second whether a grant has begun or ended; on a thread of its own, for who hears of it may ask the store. */
final class GrantWatch implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(GrantWatch.class);
    private static final long RHYTHM_MILLIS = 200;

    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread created = new Thread(task, "grants");
        created.setDaemon(true);
        return created;
    });

    private final ScheduledFuture<?> looks;

    GrantWatch(GrantBook book) {
        looks = thread.scheduleWithFixedDelay(() -> look(book), RHYTHM_MILLIS, RHYTHM_MILLIS, TimeUnit.MILLISECONDS);
    }

    private static void look(GrantBook book) {
        try {
            book.announce();
        } catch (RuntimeException e) {
            LOG.error("Not everybody could be told that a grant has begun or ended", e);
        }
    }

    @Override
    public void close() {
        looks.cancel(false);
        thread.shutdown();
    }
}
