package org.dronemap.cognitive.replan;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * The waypoints that one drone of a mission run is flying, in order: first those that stay its own, then the others.
 *
 * @param firm what comes first and stays so, as the waypoint that it is flying to
 * @param next what may be given to others
 * @param busy whether it is a while before it could be told of anything else: what has to go out at once is for others
 */
@Stored(names = "drone firm next busy")
public record LiveAssignment(DroneId drone, List<String> firm, List<String> next, boolean busy) {
    public LiveAssignment {
        firm = List.copyOf(firm);
        next = List.copyOf(next);
    }

    /** It can be told of more. */
    public LiveAssignment(DroneId drone, List<String> firm, List<String> next) {
        this(drone, firm, next, false);
    }

    /** Nothing of it is firm, and it can be told of more. */
    public static LiveAssignment of(DroneId drone, List<String> waypoints) {
        return new LiveAssignment(drone, List.of(), waypoints);
    }

    public Stream<String> waypoints() {
        return Stream.concat(firm.stream(), next.stream());
    }
}
