package org.dronemap.cognitive.cost;

import java.util.List;

/**
 * A planning problem as the search sees it: waypoint i is {@code visits.get(i)}, drone r is {@code carriers.get(r)}.
 */
public record AllocationProblem(
        Legs legs, List<AllocationWaypoint> visits, List<AllocationDrone> carriers, AllocationObjective aim) {
    public AllocationProblem {
        visits = List.copyOf(visits);
        carriers = List.copyOf(carriers);
        int places = visits.size() + 2 * carriers.size();
        if (legs.places() != places) {
            throw new IllegalArgumentException("legs know " + legs.places() + " places, not " + places);
        }
    }

    public int start(int drone) {
        return visits.size() + 2 * drone;
    }

    public int end(int drone) {
        return visits.size() + 2 * drone + 1;
    }
}
