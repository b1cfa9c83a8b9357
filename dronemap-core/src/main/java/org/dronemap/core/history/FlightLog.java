package org.dronemap.core.history;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All flights as they are now: those under way, newer than what is stored, before those that are. One thread of its own
 * writes what changed, the newest state of each flight alone, until the store takes it.
 */
public final class FlightLog implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(FlightLog.class);
    private static final int MOST_UNSAVED = 10_000;
    private static final long CLOSE_MILLIS = 5_000;

    private final FlightStore store;
    private final Duration every;
    private final ConcurrentHashMap<String, Flight> unsaved = new ConcurrentHashMap<>();
    private final Pulse pulse = new Pulse();
    private final Thread thread = new Thread(this::run, "flights");
    private volatile boolean closed;
    private volatile @Nullable String failure;

    /** {@code every}: so often what changed is written. */
    public FlightLog(FlightStore store, Duration every) {
        this.store = store;
        this.every = every;
        thread.setDaemon(true);
    }

    public void start() {
        thread.start();
    }

    /** Returns at once. */
    void keep(Flight flight) {
        if (unsaved.size() < MOST_UNSAVED || unsaved.containsKey(flight.id())) {
            unsaved.put(flight.id(), flight);
        } else {
            LOG.error("Too many flights wait for the store: {} is not kept", flight);
        }
    }

    /** A sentence when flights cannot be written at the moment. */
    public Optional<String> trouble() {
        return Optional.ofNullable(failure);
    }

    public List<Flight> flights(FlightQuery query, @Nullable Flight after, int limit) {
        return store.flights(query, after, limit);
    }

    public Optional<Flight> flight(String id) {
        return store.flight(id);
    }

    /** False when there is no such flight. */
    public boolean annotate(String id, String notes) {
        return store.annotate(id, notes);
    }

    List<Flight> open() {
        return store.open();
    }

    private void run() {
        while (!closed) {
            if (!pulse.rest(every)) {
                closed = true;
            }
            saveAll();
        }
    }

    private void saveAll() {
        try {
            for (Flight flight : unsaved.values()) {
                store.save(flight);
                // Unless it has changed meanwhile.
                unsaved.remove(flight.id(), flight);
            }
            failure = null;
        } catch (RuntimeException e) {
            if (failure == null) {
                LOG.warn("Flights cannot be written for now; they wait", e);
            }
            failure = "Flights cannot be written: " + e.getMessage();
        }
    }

    /** Writes what waits, within some seconds. */
    @Override
    public void close() {
        closed = true;
        pulse.wake();
        try {
            thread.join(CLOSE_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
