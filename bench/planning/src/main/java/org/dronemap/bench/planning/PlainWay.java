package org.dronemap.bench.planning;

import java.util.function.Consumer;
import org.dronemap.cognitive.allocate.Baseline;

/** A baseline of the planner: it ends by itself, however much it may use. */
public final class PlainWay implements Solver {
    private final String about;
    private final Baseline baseline;

    public PlainWay(String about, Baseline baseline) {
        this.about = about;
        this.baseline = baseline;
    }

    @Override
    public String about() {
        return about;
    }

    @Override
    public int[][] solve(TourProblem problem, Order order, Consumer<int[][]> improved) {
        int[][] orders = orders(problem);
        improved.accept(orders);
        return orders;
    }

    public int[][] orders(TourProblem problem) {
        return baseline.allocate(Engine.instance(problem)).orders();
    }
}
