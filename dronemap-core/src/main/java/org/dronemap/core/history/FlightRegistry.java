package org.dronemap.core.history;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All flights, those under way and the stored ones; writes changes to the FlightStore on its own thread. One thread of
 * its own writes what changed, the newest state of each flight alone, until the store takes it.
 */
public final class FlightRegistry implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(FlightRegistry.class);
    private static final int MOST_UNSAVED = 10_000;
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(5);

    private final FlightStore store;
    private final long everyNanos;
    private final ConcurrentHashMap<String, Flight> unsaved = new ConcurrentHashMap<>();
    private final Loop loop;
    private volatile @Nullable String failure;

    /** {@code every}: so often what changed is written. */
    public FlightRegistry(FlightStore store, Duration every, Time time) {
        this.store = store;
        this.everyNanos = every.toNanos();
        this.loop = time.loop("flights", this::saveAll);
    }

    public void start() {
        loop.start();
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
    public Optional<String> problem() {
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

    private long saveAll() {
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
        return everyNanos;
    }

    /** Writes what waits, within some seconds. */
    @Override
    public void close() {
        if (!loop.finish(LONGEST_CLOSE)) {
            LOG.warn("Not all flights were written when the flight log was closed");
        }
    }
}
