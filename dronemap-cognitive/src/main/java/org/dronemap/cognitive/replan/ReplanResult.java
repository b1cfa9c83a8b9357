package org.dronemap.cognitive.replan;

import java.util.List;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * The result of a re-planning: the new plan, what it changes, its figures and its faults.
 *
 * @param before the live orders as far as they can still be flown, orphans unserved
 * @param iterations how many changes were tried
 * @param faults why it must not be flown, as sentences of the independent checker; none for a plan that can be
 */
@Stored(names = "plan changes before after iterations faults")
public record ReplanResult(
        Plan plan, Changes changes, PlanFigures before, PlanFigures after, long iterations, List<String> faults) {
    public ReplanResult {
        faults = List.copyOf(faults);
    }

    public boolean canBeFlown() {
        return faults.isEmpty();
    }

    /**
     * Differences from the plan before: waypoints moved, and drones whose order changed.
     *
     * @param moved in the order of the problem's waypoints
     * @param drones those whose order is another one, in the order of the problem; done and cancelled waypoints do not count
     */
    @Stored(names = "moved drones")
    public record Changes(List<ReassignedWaypoint> moved, List<DroneId> drones) {
        public Changes {
            moved = List.copyOf(moved);
            drones = List.copyOf(drones);
        }
    }
}
