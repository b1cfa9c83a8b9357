package org.dronemap.cognitive.plan;

import java.util.List;
import org.dronemap.core.stored.Stored;

/** A plan: the drones' tours and the waypoints left out; drones without a tour stay where they are. */
@Stored(names = "tours unserved")
public record Plan(List<Tour> tours, List<UnservedWaypoint> unserved) {
    public Plan {
        tours = List.copyOf(tours);
        unserved = List.copyOf(unserved);
    }

    /** When the last drone is at its end; 0 when nobody flies. */
    public double endsSeconds() {
        return tours.stream().mapToDouble(Tour::endsSeconds).max().orElse(0);
    }
}
