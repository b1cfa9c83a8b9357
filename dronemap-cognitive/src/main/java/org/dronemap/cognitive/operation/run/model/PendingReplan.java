package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.stored.Stored;

/**
 * A re-planning that a mission run has requested and waits for.
 *
 * @param number of all that were asked for, from 1
 * @param better whether a better one than the present one is looked for, else one at once
 * @param searched a search went on from the plan at once
 * @param approved somebody said yes to it already
 * @param at when: zero of the plan's clock
 * @param crafts the drones that it is for, as they were
 */
@Stored(names = "number better searched approved at causes crafts")
public record PendingReplan(
        int number,
        boolean better,
        boolean searched,
        boolean approved,
        Instant at,
        List<ReplanCause> causes,
        List<Craft> crafts) {
    public PendingReplan {
        causes = List.copyOf(causes);
        crafts = List.copyOf(crafts);
    }

    public static PendingReplan of(
            int number, boolean searched, Instant at, List<ReplanCause> causes, List<Craft> crafts) {
        boolean better = causes.stream().allMatch(ReplanCause::isBetter);
        boolean approved = causes.stream().anyMatch(cause -> cause.trigger() == RunTrigger.ANSWERED);
        List<ReplanCause> real =
                causes.stream().filter(cause -> better || !cause.isBetter()).toList();
        return new PendingReplan(number, better, searched, approved, at, real, crafts);
    }

    /** What it is told by. */
    public ReplanCause first() {
        return Objects.requireNonNull(causes.get(0));
    }
}
