package org.dronemap.cognitive.replan;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;

/**
 * What one drone has been told to visit, in order, as far as it is not done.
 *
 * @param firm what comes first and stays so, as the waypoint that it is flying to
 * @param next what may be given to others
 */
public record LiveOrder(DroneId drone, List<String> firm, List<String> next) {
    public LiveOrder {
        firm = List.copyOf(firm);
        next = List.copyOf(next);
    }

    /** Nothing of it is firm. */
    public static LiveOrder of(DroneId drone, List<String> waypoints) {
        return new LiveOrder(drone, List.of(), waypoints);
    }

    public Stream<String> waypoints() {
        return Stream.concat(firm.stream(), next.stream());
    }
}
