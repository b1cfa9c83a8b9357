package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.stored.Stored;

/**
 * A new plan for a mission run that waits for a user's approval.
 *
 * @param number of all of this run, from 1
 * @param at zero of the plan's clock
 * @param words what it would change and why
 */
@Stored(names = "number at causes plan words")
public record ReplanProposal(int number, Instant at, List<ReplanCause> causes, ReplanResult plan, String words) {
    public ReplanProposal {
        causes = List.copyOf(causes);
    }
}
