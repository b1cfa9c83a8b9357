package org.dronemap.bench.planning.library;

import ai.timefold.solver.core.api.solver.Solver;
import ai.timefold.solver.core.api.solver.SolverFactory;
import ai.timefold.solver.core.config.constructionheuristic.ConstructionHeuristicPhaseConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.composite.UnionMoveSelectorConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.generic.list.ListChangeMoveSelectorConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.generic.list.ListRuinRecreateMoveSelectorConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.generic.list.ListSwapMoveSelectorConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.generic.list.SubListChangeMoveSelectorConfig;
import ai.timefold.solver.core.config.heuristic.selector.move.generic.list.kopt.KOptListMoveSelectorConfig;
import ai.timefold.solver.core.config.localsearch.LocalSearchPhaseConfig;
import ai.timefold.solver.core.config.localsearch.LocalSearchType;
import ai.timefold.solver.core.config.score.director.ScoreDirectorFactoryConfig;
import ai.timefold.solver.core.config.solver.EnvironmentMode;
import ai.timefold.solver.core.config.solver.SolverConfig;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.dronemap.bench.planning.TourProblem;

/** Timefold: cheapest insertion, then late acceptance over changes, swaps, stretches and k-opt, with an incremental score. */
public final class TimefoldSolver implements org.dronemap.bench.planning.Solver {
    private static final long LOOK_MILLIS = 5;

    private final EnvironmentMode mode;

    public TimefoldSolver() {
        this(EnvironmentMode.NON_REPRODUCIBLE);
    }

    TimefoldSolver(EnvironmentMode mode) {
        this.mode = mode;
    }

    @Override
    public String about() {
        return "Timefold: insertion, late acceptance (change, swap, stretch, k-opt, ruin), incremental score: "
                + "16-norm of the tours + 0.2 of the mean";
    }

    @Override
    public int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved) {
        if (!problem.longest()) {
            throw new IllegalArgumentException("set up for the longest tour only");
        }
        Solver<TimefoldSolution> solver =
                SolverFactory.<TimefoldSolution>create(config(order.seed())).buildSolver();
        solver.addEventListener(event -> {
            if (event.getNewBestSolution().isWhole()) {
                improved.accept(event.getNewBestSolution().orders());
            }
        });
        ScheduledExecutorService watch = Executors.newSingleThreadScheduledExecutor();
        try {
            Runnable look = () -> {
                if (order.allowance().isSpent()) {
                    solver.terminateEarly();
                }
            };
            ScheduledFuture<?> looks =
                    watch.scheduleWithFixedDelay(look, LOOK_MILLIS, LOOK_MILLIS, TimeUnit.MILLISECONDS);
            int[][] orders = solver.solve(TimefoldSolution.of(problem)).orders();
            looks.cancel(false);
            return orders;
        } finally {
            watch.shutdownNow();
        }
    }

    private SolverConfig config(long seed) {
        return new SolverConfig()
                .withEnvironmentMode(mode)
                .withRandomSeed(seed)
                .withSolutionClass(TimefoldSolution.class)
                .withEntityClasses(TimefoldRoute.class)
                .withScoreDirectorFactory(
                        new ScoreDirectorFactoryConfig().withIncrementalScoreCalculatorClass(LongestTourScore.class))
                .withPhases(
                        new ConstructionHeuristicPhaseConfig(),
                        new LocalSearchPhaseConfig()
                                .withLocalSearchType(LocalSearchType.LATE_ACCEPTANCE)
                                .withMoveSelectorConfig(new UnionMoveSelectorConfig()
                                        .withMoveSelectors(
                                                new ListChangeMoveSelectorConfig(),
                                                new ListSwapMoveSelectorConfig(),
                                                new SubListChangeMoveSelectorConfig(),
                                                new KOptListMoveSelectorConfig(),
                                                new ListRuinRecreateMoveSelectorConfig())));
    }
}
