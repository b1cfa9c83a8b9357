package org.dronemap.cognitive.allocate;

import java.util.List;
import org.dronemap.cognitive.cost.Instance;

/** Waypoints as they were entered, cut into as many stretches of one length as there are drones. */
public final class GivenOrder implements Baseline {
    @Override
    public Allocation allocate(Instance instance) {
        Costs costs = new Costs(instance);
        List<Round> rounds = Round.all(instance, costs);
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
