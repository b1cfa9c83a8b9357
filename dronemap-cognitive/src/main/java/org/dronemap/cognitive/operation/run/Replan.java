package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.InstantSource;
import java.util.function.BooleanSupplier;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.replan.Replanned;
import org.dronemap.cognitive.replan.Replanning;
import org.dronemap.cognitive.replan.Situation;
import org.dronemap.core.operation.Computation;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.Time;

/**
 * A plan for a situation.
 *
 * @param request the number that its result comes back with
 * @param limit how long a better one is looked for; zero: the one at once
 */
@Stored(as = "Replan", names = "request situation seed limit")
public record Replan(int request, Situation situation, long seed, Duration limit) implements Computation<RunInput> {
    /** Drones hover meanwhile: what processors there are help, but never more than these. */
    private static final int MOST_SEARCHES = 4;

    @Override
    public RunInput run(Time time, BooleanSupplier cancelled) {
        int searches = Math.min(MOST_SEARCHES, time.parallelism());
        Replanning replanning = new Replanning(situation);
        if (limit.isZero()) {
            return new RunInput.Replanned(time.clock().instant(), request, replanning.atOnce(), null);
        }
        Budget budget = Budget.time(limit, time.effort()).orWhen(cancelled);
        try (Pool helpers = time.pool("replan", searches, 0)) {
            Replanned result = replanning.improve(seed, budget, searches, helpers);
            return new RunInput.Replanned(time.clock().instant(), request, result, null);
        }
    }

    @Override
    public RunInput failed(String why, InstantSource clock) {
        return new RunInput.Replanned(clock.instant(), request, null, why);
    }
}
