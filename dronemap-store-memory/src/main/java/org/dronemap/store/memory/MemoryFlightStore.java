package org.dronemap.store.memory;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.history.Flight;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.core.history.FlightStore;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/** Keeps flights in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryFlightStore implements FlightStore {
    private static final Comparator<Flight> NEWEST_FIRST =
            Comparator.comparing(Flight::start).thenComparing(Flight::id).reversed();

    private final Map<String, Flight> flights = new HashMap<>();

    @Override
    public synchronized List<Flight> flights(FlightQuery query, @Nullable Flight after, int limit) {
        return ordered()
                .filter(flight -> after == null || NEWEST_FIRST.compare(flight, after) > 0)
                .filter(flight -> matches(query, flight))
                .limit(limit)
                .toList();
    }

    private static boolean matches(FlightQuery query, Flight flight) {
        return (query.drone() == null || query.drone().equals(flight.drone()))
                && (query.user() == null || flight.users().contains(query.user()))
                && (query.from() == null || !flight.start().isBefore(query.from()))
                && (query.until() == null || flight.start().isBefore(query.until()))
                && (query.words() == null
                        || words(flight).contains(query.words().toLowerCase(Locale.ROOT)));
    }

    private static String words(Flight flight) {
        Flight.FlightOperation operation = flight.operation();
        String all = flight.droneName() + "\n" + flight.notes() + "\n" + (operation == null ? "" : operation.words());
        return all.toLowerCase(Locale.ROOT);
    }

    @Override
    public synchronized Optional<Flight> flight(String id) {
        return Optional.ofNullable(flights.get(id));
    }

    @Override
    public synchronized List<Flight> open() {
        Map<String, Flight> newest = new HashMap<>();
        ordered()
                .filter(flight -> flight.state() != Flight.State.ENDED)
                .forEach(flight -> newest.putIfAbsent(flight.drone().value(), flight));
        return List.copyOf(newest.values());
    }

    @Override
    public synchronized void save(Flight flight) {
        Flight known = flights.get(flight.id());
        flights.put(flight.id(), stored(flight, known == null ? flight.notes() : known.notes()));
    }

    @Override
    public synchronized boolean annotate(String id, String notes) {
        return flights.computeIfPresent(id, (key, flight) -> stored(flight, notes)) != null;
    }

    private Stream<Flight> ordered() {
        return flights.values().stream().sorted(NEWEST_FIRST);
    }

    private static Flight stored(Flight flight, String notes) {
        return new Flight(
                flight.id(),
                flight.drone(),
                flight.droneName(),
                StoredInstant.of(flight.start()),
                flight.end() == null ? null : StoredInstant.of(flight.end()),
                flight.state(),
                StoredInstant.of(flight.lastHeardAt()),
                flight.measures(),
                flight.users(),
                flight.operation(),
                flight.notice(),
                notes);
    }
}
