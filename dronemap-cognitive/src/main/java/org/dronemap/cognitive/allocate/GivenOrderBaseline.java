package org.dronemap.cognitive.allocate;

import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * Baseline allocation: cuts the waypoints, in the order in which they were entered, into one equal stretch for each
 * drone.
 */
public final class GivenOrderBaseline implements Baseline {
    @Override
    public Allocation allocate(AllocationProblem instance) {
        LegCosts costs = new LegCosts(instance);
        List<BaselineTour> rounds = BaselineTour.all(instance, costs);
        int drones = rounds.size();
        int waypoints = instance.visits().size();
        for (int waypoint = 0; waypoint < waypoints; waypoint++) {
            int first = (int) ((long) waypoint * drones / waypoints);
            boolean taken = false;
            for (int i = 0; i < drones && !taken; i++) {
                taken = rounds.get((first + i) % drones).append(waypoint);
            }
        }
        return Allocation.of(instance, costs, rounds);
    }
}
