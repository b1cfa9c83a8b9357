package org.dronemap.bench.planning;

import java.util.function.Consumer;
import org.dronemap.cognitive.allocate.Baseline;

/** A baseline of the planner: it ends by itself, however much it may use. */
public final class BaselineSolver implements Solver {
    private final String about;
    private final Baseline baseline;

    public BaselineSolver(String about, Baseline baseline) {
        this.about = about;
        this.baseline = baseline;
    }

    @Override
    public String about() {
        return about;
    }

    @Override
    public int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved) {
        int[][] orders = orders(problem);
        improved.accept(orders);
        return orders;
    }

    public int[][] orders(TourProblem problem) {
        return baseline.allocate(DronemapSolver.instance(problem)).orders();
    }
}
