package org.dronemap.cognitive.operation.run;

import java.time.Clock;
import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.concurrent.ForkJoinPool;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.replan.Replanned;
import org.dronemap.cognitive.replan.Replanning;
import org.dronemap.cognitive.replan.Situation;
import org.dronemap.core.operation.Computation;

/**
 * A plan for a situation.
 *
 * @param request the number that its result comes back with
 * @param limit how long a better one is looked for; zero: the one at once
 */
public record Replan(int request, Situation situation, long seed, Duration limit) implements Computation<RunInput> {
    /** Drones hover meanwhile: what processors there are help, but never more than these. */
    private static final int MOST_SEARCHES = 4;

    @Override
    public RunInput run(LongSupplier nanoTime, Clock clock, BooleanSupplier cancelled) {
        // Where the pool is busy, the budget is spent before a search begins, and the others' plan counts.
        return run(
                nanoTime,
                clock,
                cancelled,
                Math.min(MOST_SEARCHES, Runtime.getRuntime().availableProcessors()),
                ForkJoinPool.commonPool());
    }

    RunInput run(LongSupplier nanoTime, Clock clock, BooleanSupplier cancelled, int searches, Executor executor) {
        Replanning replanning = new Replanning(situation);
        Replanned result = limit.isZero()
                ? replanning.atOnce()
                : replanning.improve(seed, Budget.time(limit, nanoTime).orWhen(cancelled), searches, executor);
        return new RunInput.Replanned(clock.instant(), request, result, null);
    }

    @Override
    public RunInput failed(String why, Clock clock) {
        return new RunInput.Replanned(clock.instant(), request, null, why);
    }
}
