package org.dronemap.core.history;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Stores flights; every write returns only after it is durable. Any thread. */
public interface FlightStore {
    /** Newest start first, those after {@code after} in that order (null: from the newest), at most {@code limit}. */
    List<Flight> flights(FlightQuery query, @Nullable Flight after, int limit);

    Optional<Flight> flight(String id);

    /** Those that have not ended: of one drone only the newest. */
    List<Flight> open();

    /** Inserts, or replaces all but the notes. */
    void save(Flight flight);

    /** False when there is no such flight. */
    boolean annotate(String id, String notes);
}
