package org.dronemap.core.history;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/** Flights that a test can look at, in a store that it can break. */
final class FailingFlightStore implements FlightStore {
    final ConcurrentHashMap<String, Flight> flights = new ConcurrentHashMap<>();
    volatile boolean broken;

    @Override
    public List<Flight> flights(FlightQuery query, @Nullable Flight after, int limit) {
        return new ArrayList<>(flights.values());
    }

    @Override
    public Optional<Flight> flight(String id) {
        return Optional.ofNullable(flights.get(id));
    }

    @Override
    public List<Flight> open() {
        return flights.values().stream()
                .filter(flight -> flight.state() != Flight.State.ENDED)
                .toList();
    }

    @Override
    public void save(Flight flight) {
        if (broken) {
            throw new IllegalStateException("the disk is full");
        }
        flights.put(flight.id(), flight);
    }

    @Override
    public boolean annotate(String id, String notes) {
        return flights.containsKey(id);
    }
}
