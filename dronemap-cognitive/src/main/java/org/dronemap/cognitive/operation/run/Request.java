package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.stored.Stored;

/**
 * A plan that was asked for.
 *
 * @param number of all that were asked for, from 1
 * @param better whether a better one than the present one is looked for, else one at once
 * @param searched a search went on from the plan at once
 * @param approved somebody said yes to it already
 * @param at when: zero of the plan's clock
 * @param crafts the drones that it is for, as they were
 */
@Stored(names = "number better searched approved at causes crafts")
public record Request(
        int number,
        boolean better,
        boolean searched,
        boolean approved,
        Instant at,
        List<Cause> causes,
        List<Craft> crafts) {
    public Request {
        causes = List.copyOf(causes);
        crafts = List.copyOf(crafts);
    }

    static Request of(int number, boolean searched, Instant at, List<Cause> causes, List<Craft> crafts) {
        boolean better = causes.stream().allMatch(Cause::isBetter);
        boolean approved = causes.stream().anyMatch(cause -> cause.trigger() == Trigger.ANSWERED);
        List<Cause> real =
                causes.stream().filter(cause -> better || !cause.isBetter()).toList();
        return new Request(number, better, searched, approved, at, real, crafts);
    }

    /** What it is told by. */
    Cause first() {
        return Objects.requireNonNull(causes.get(0));
    }
}
