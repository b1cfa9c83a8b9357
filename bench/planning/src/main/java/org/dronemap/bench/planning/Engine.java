package org.dronemap.bench.planning;

import java.util.BitSet;
import java.util.Collections;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.dronemap.cognitive.allocate.Allocator;
import org.dronemap.cognitive.allocate.Crew;
import org.dronemap.cognitive.cost.Aim;
import org.dronemap.cognitive.cost.Carrier;
import org.dronemap.cognitive.cost.Instance;
import org.dronemap.cognitive.cost.Visit;

/** Our own search, at a speed of one unit a second; with several threads each searches by itself, and the best counts. */
final class Engine implements Solver {
    @Override
    public String about() {
        return "Dronemap's own search as it ships";
    }

    @Override
    public int[][] solve(TourProblem problem, Order order, Consumer<int[][]> improved) {
        ExecutorService threads = Executors.newFixedThreadPool(order.threads());
        try {
            return new Crew(new Allocator(instance(problem)), order.threads(), threads)
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
    static Instance instance(TourProblem problem) {
        BitSet all = new BitSet();
        all.set(0, problem.drones());
        Visit visit = new Visit(0, 0, 1, 0, Double.POSITIVE_INFINITY, all);
        Carrier carrier = new Carrier(0, 0, Double.POSITIVE_INFINITY);
        Aim aim = problem.longest()
                ? Aim.minMax()
                : Aim.minSum(Aim.Measure.SECONDS).withEveryDrone();
        return new Instance(
                new StraightLegs(problem),
                Collections.nCopies(problem.waypoints().size(), visit),
                Collections.nCopies(problem.drones(), carrier),
                aim);
    }
}
