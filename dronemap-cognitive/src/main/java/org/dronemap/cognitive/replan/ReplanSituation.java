package org.dronemap.cognitive.replan;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * The input of a re-planning: the problem as it stands, and the waypoints that drones are flying.
 *
 * @param problem drones where they are when the new plan begins, in flight or on the ground, and the waypoints that may be
 *     given out; what is reserved for a silent vehicle is not among them
 * @param live what drones have been told to do; those of drones that are not in the problem have lost their drone, and
 *     waypoints that are not in the problem are done, cancelled or reserved
 */
@Stored(names = "problem live")
public record ReplanSituation(PlanningProblem problem, List<LiveAssignment> live) {
    public ReplanSituation {
        live = List.copyOf(live);
        Set<DroneId> drones = new HashSet<>();
        Set<String> waypoints = new HashSet<>();
        for (LiveAssignment order : live) {
            if (!drones.add(order.drone())) {
                throw new IllegalArgumentException("the drone " + order.drone() + " has two live orders");
            }
            order.waypoints().forEach(waypoint -> {
                if (!waypoints.add(waypoint)) {
                    throw new IllegalArgumentException("the waypoint " + waypoint + " is in live orders twice");
                }
            });
        }
    }
}
