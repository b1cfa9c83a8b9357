package org.dronemap.bench.planning;

import java.util.function.Consumer;

/** A way to solve a problem. */
public interface Solver {
    /** What is measured, with its settings, in a few words. */
    String about();

    /**
     * Searches until the allowance is spent.
     *
     * @param improved hears of better tours, on any thread
     * @return for each drone its waypoints in order
     */
    int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved);

    /**
     * Options of a search: seed, threads and CPU budget.
     *
     * @param threads how many may search; a solver that knows one only uses one
     */
    record SearchOptions(long seed, int threads, CpuBudget allowance) {}
}
