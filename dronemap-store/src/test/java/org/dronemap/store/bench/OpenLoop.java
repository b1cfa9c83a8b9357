package org.dronemap.store.bench;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongFunction;
import org.dronemap.core.history.FlightLog;
import org.dronemap.core.history.History;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.HistoryKeeper;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.time.SystemTime;
import org.dronemap.store.postgres.Database;

/**
 * All that a server does to remember its drones, from a state to the disk, fed with so many states a second whether it keeps
 * up or not. One thread.
 */
final class OpenLoop implements AutoCloseable {
    private static final double NANOS = 1e9;
    private static final long PAUSE_NANOS = 5_000_000;

    private final TelemetryWriter writer;
    private final FlightLog flights;
    private final History history;
    private final int rate;
    private long brought;
    private int lastFlight;

    OpenLoop(Database database, int rate) {
        TelemetryStore store = database.telemetry();
        Retention retention = Retention.DEFAULT;
        HistoryKeeper keeper = new HistoryKeeper(store, retention, new SystemTime());
        this.rate = rate;
        writer = new TelemetryWriter(store, TelemetryWriter.Rhythm.DEFAULT, new SystemTime());
        flights = new FlightLog(database.flights(), Duration.ofSeconds(1), new SystemTime());
        // Each state counts, however close to the one before.
        HistoryPolicy all = new HistoryPolicy(Duration.ofMillis(1), Duration.ofMillis(1), retention);
        history = new History(
                new History.Keeping(store, writer, flights, keeper),
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
                history.droneChanged(BenchFleet.state(brought, BenchFleet.drone(brought), times.apply(brought)));
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
