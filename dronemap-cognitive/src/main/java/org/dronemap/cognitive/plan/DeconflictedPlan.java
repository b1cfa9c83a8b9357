package org.dronemap.cognitive.plan;

import java.util.List;

/**
 * A plan whose drones keep apart as far as that could be had.
 *
 * @param conflicts what is left
 */
public record DeconflictedPlan(Plan plan, List<Conflict> conflicts) {
    public DeconflictedPlan {
        conflicts = List.copyOf(conflicts);
    }
}
