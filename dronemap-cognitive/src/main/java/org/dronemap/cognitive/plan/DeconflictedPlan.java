package org.dronemap.cognitive.plan;

import java.util.List;

/**
 * A plan after deconfliction, with the conflicts between drones that could not be resolved.
 *
 * @param conflicts what is left
 */
public record DeconflictedPlan(Plan plan, List<SeparationConflict> conflicts) {
    public DeconflictedPlan {
        conflicts = List.copyOf(conflicts);
    }
}
