package org.dronemap.bench.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Notes when the best tours so far were found. Safe for several threads. */
final class Convergence implements Consumer<int[][]> {
    private final TourProblem problem;
    private final CpuBudget allowance;
    private final List<Point> points = new ArrayList<>();
    private int[][] orders = new int[0][];
    private double best = Double.POSITIVE_INFINITY;

    Convergence(TourProblem problem, CpuBudget allowance) {
        this.problem = problem;
        this.allowance = allowance;
    }

    /** From then on the best value was this. */
    record Point(double cpuSeconds, double value) {}

    @Override
    public synchronized void accept(int[][] found) {
        double value = problem.value(found);
        if (value < best && problem.isServedBy(found)) {
            best = value;
            orders = found;
            points.add(new Point(allowance.usedSeconds(), value));
        }
    }

    /** The best tours; what a library calls best may be another plan, where its own aim is a smoother one. */
    synchronized int[][] best() {
        return orders;
    }

    synchronized List<Point> points() {
        return List.copyOf(points);
    }
}
