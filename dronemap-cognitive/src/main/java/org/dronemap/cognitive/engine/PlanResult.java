package org.dronemap.cognitive.engine;

import java.util.List;
import org.dronemap.cognitive.plan.Plan;

/**
 * A plan with the figures of its search and the faults that the independent checker found.
 *
 * @param progress the figures of the plan as it was found; keeping drones apart may have made it longer
 * @param faults why the plan must not be flown, as sentences of the independent checker; none for a plan that can be
 */
public record PlanResult(Plan plan, SearchProgress progress, List<String> faults) {
    public PlanResult {
        faults = List.copyOf(faults);
    }

    public boolean canBeFlown() {
        return faults.isEmpty();
    }
}
