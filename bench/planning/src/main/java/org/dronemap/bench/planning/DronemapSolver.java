package org.dronemap.bench.planning;

import java.util.BitSet;
import java.util.Collections;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.dronemap.cognitive.allocate.Allocator;
import org.dronemap.cognitive.allocate.ParallelSearch;
import org.dronemap.cognitive.cost.AllocationDrone;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.dronemap.cognitive.cost.AllocationWaypoint;

/** Our own search, at a speed of one unit a second; with several threads each searches by itself, and the best counts. */
final class DronemapSolver implements Solver {
    @Override
    public String about() {
        return "Dronemap's own search as it ships";
    }

    @Override
    public int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved) {
        ExecutorService threads = Executors.newFixedThreadPool(order.threads());
        try {
            return new ParallelSearch(new Allocator(instance(problem)), order.threads(), threads)
                    .search(
                            order.seed(),
                            iterations -> order.allowance().share(),
                            better -> improved.accept(better.orders()))
                    .orders();
        } finally {
            threads.shutdownNow();
        }
    }

    /** Published sums hold for plans in which every drone flies. */
    static AllocationProblem instance(TourProblem problem) {
        BitSet all = new BitSet();
        all.set(0, problem.drones());
        AllocationWaypoint visit = new AllocationWaypoint(0, 0, 1, 0, Double.POSITIVE_INFINITY, all);
        AllocationDrone carrier = new AllocationDrone(0, 0, Double.POSITIVE_INFINITY);
        AllocationObjective aim = problem.longest()
                ? AllocationObjective.minMax()
                : AllocationObjective.minSum(AllocationObjective.Measure.SECONDS).withEveryDrone();
        return new AllocationProblem(
                new StraightLegs(problem),
                Collections.nCopies(problem.waypoints().size(), visit),
                Collections.nCopies(problem.drones(), carrier),
                aim);
    }
}
