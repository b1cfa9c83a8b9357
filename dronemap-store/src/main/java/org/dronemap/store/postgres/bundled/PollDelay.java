package org.dronemap.store.postgres.bundled;

import java.time.Duration;
import org.dronemap.store.StoreException;

/** Sleeps between two looks at a PostgreSQL process that is starting or stopping. */
final class PollDelay {
    private PollDelay() {}

    static void of(Duration duration) {
        try {
            Thread.sleep(duration.toMillis());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new StoreException("Interrupted while waiting for the database.", e);
        }
    }
}
