package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.InstantSource;
import java.util.function.BooleanSupplier;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.cognitive.replan.ReplanSituation;
import org.dronemap.cognitive.replan.Replanner;
import org.dronemap.core.operation.Computation;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.Time;

/**
 * The background computation of a re-planning for a mission run: its situation, seed and time limit.
 *
 * @param request the number that its result comes back with
 * @param limit how long a better one is looked for; zero: the one at once
 */
@Stored(as = "Replan", names = "request situation seed limit")
public record ReplanComputation(int request, ReplanSituation situation, long seed, Duration limit)
        implements Computation<RunInput> {
    /** Drones hover meanwhile: what processors there are help, but never more than these. */
    private static final int MOST_SEARCHES = 4;

    @Override
    public RunInput run(Time time, BooleanSupplier cancelled) {
        int searches = Math.min(MOST_SEARCHES, time.parallelism());
        Replanner replanning = new Replanner(situation);
        if (limit.isZero()) {
            return new RunInput.ReplanEnded(time.clock().instant(), request, replanning.atOnce(), null);
        }
        SearchBudget budget = SearchBudget.time(limit, time.effort()).orWhen(cancelled);
        try (Pool helpers = time.pool("replan", searches, 0)) {
            ReplanResult result = replanning.improve(seed, budget, searches, helpers);
            return new RunInput.ReplanEnded(time.clock().instant(), request, result, null);
        }
    }

    @Override
    public RunInput failed(String why, InstantSource clock) {
        return new RunInput.ReplanEnded(clock.instant(), request, null, why);
    }
}
