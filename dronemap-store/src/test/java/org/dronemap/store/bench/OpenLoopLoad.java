package org.dronemap.store.bench;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongFunction;
import org.dronemap.core.history.FlightRegistry;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.HistoryMaintenance;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.time.RealTime;
import org.dronemap.store.postgres.PostgresStores;

/**
 * All that a server does to remember its drones, from a state to the disk, fed with so many states a second whether it keeps
 * up or not. One thread.
 */
final class OpenLoopLoad implements AutoCloseable {
    private static final double NANOS = 1e9;
    private static final long PAUSE_NANOS = 5_000_000;

    private final TelemetryWriter writer;
    private final FlightRegistry flights;
    private final HistoryRecorder history;
    private final int rate;
    private long brought;
    private int lastFlight;

    OpenLoopLoad(PostgresStores database, int rate) {
        TelemetryStore store = database.telemetry();
        Retention retention = Retention.DEFAULT;
        HistoryMaintenance keeper = new HistoryMaintenance(store, retention, new RealTime());
        this.rate = rate;
        writer = new TelemetryWriter(store, TelemetryWriter.BatchSettings.DEFAULT, new RealTime());
        flights = new FlightRegistry(database.flights(), Duration.ofSeconds(1), new RealTime());
        // Each state counts, however close to the one before.
        HistoryPolicy all = new HistoryPolicy(Duration.ofMillis(1), Duration.ofMillis(1), retention);
        history = new HistoryRecorder(
                new HistoryRecorder.Persistence(store, writer, flights, keeper),
                all,
                InstantSource.system(),
                () -> System.nanoTime() + "-" + ++lastFlight);
        writer.start();
        flights.start();
    }

    /** Until {@code all} states were brought; {@code times} says when each one was measured. Returns the seconds it took. */
    double bring(long all, LongFunction<Instant> times) {
        long start = System.nanoTime();
        while (brought < all) {
            long due = Math.min(all, (long) ((System.nanoTime() - start) / NANOS * rate));
            while (brought < due) {
                history.droneChanged(
                        BenchmarkFleet.state(brought, BenchmarkFleet.drone(brought), times.apply(brought)));
                brought++;
            }
            LockSupport.parkNanos(PAUSE_NANOS);
        }
        return (System.nanoTime() - start) / NANOS;
    }

    HistoryHealth health() {
        return history.health();
    }

    @Override
    public void close() {
        writer.close();
        flights.close();
    }
}
