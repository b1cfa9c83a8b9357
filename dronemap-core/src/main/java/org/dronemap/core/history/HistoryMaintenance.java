package org.dronemap.core.history;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Prepares the telemetry store for coming days and thins or deletes old ones, on its own thread. */
public final class HistoryMaintenance implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(HistoryMaintenance.class);

    private final TelemetryStore store;
    private final Retention retention;
    private final InstantSource clock;
    private final Worker thread;
    private volatile @Nullable String failure;

    public HistoryMaintenance(TelemetryStore store, Retention retention, Time time) {
        this.store = store;
        this.retention = retention;
        this.clock = time.clock();
        this.thread = time.worker("history-keeper", 1);
    }

    /** At once, and then again and again. */
    public void start(Duration every) {
        ScheduledTask unused = thread.every(Duration.ZERO, every, this::tidy);
    }

    /** A sentence when it did not work the last time. */
    public Optional<String> trouble() {
        return Optional.ofNullable(failure);
    }

    private void tidy() {
        try {
            store.tidy(retention, clock.instant());
            failure = null;
        } catch (RuntimeException e) {
            LOG.warn("Telemetry cannot be tidied up now; it is tried again", e);
            failure = "Old telemetry cannot be taken away: " + e.getMessage();
        }
    }

    @Override
    public void close() {
        thread.close();
    }
}
