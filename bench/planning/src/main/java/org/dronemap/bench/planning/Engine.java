package org.dronemap.bench.planning;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import org.dronemap.cognitive.allocate.Allocator;
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
        Allocator allocator = new Allocator(instance(problem));
        if (order.threads() == 1) {
            return search(allocator, order, 0, improved);
        }
        ExecutorService threads = Executors.newFixedThreadPool(order.threads());
        try {
            List<Future<int[][]>> searches = new ArrayList<>();
            for (int i = 0; i < order.threads(); i++) {
                int number = i;
                searches.add(threads.submit(() -> search(allocator, order, number, improved)));
            }
            return best(problem, searches);
        } finally {
            threads.shutdownNow();
        }
    }

    private static int[][] search(Allocator allocator, Order order, int number, Consumer<int[][]> improved) {
        return allocator
                .search(
                        order.seed() + 1_000_003L * number,
                        iterations -> order.allowance().share(),
                        better -> improved.accept(better.orders()))
                .orders();
    }

    private static int[][] best(TourProblem problem, List<Future<int[][]>> searches) {
        int[][] best = new int[0][];
        double least = Double.POSITIVE_INFINITY;
        for (Future<int[][]> search : searches) {
            int[][] orders = result(search);
            double value = problem.value(orders);
            if (value < least) {
                least = value;
                best = orders;
            }
        }
        return best;
    }

    private static int[][] result(Future<int[][]> search) {
        try {
            return search.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while searching", e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("a search failed", e.getCause());
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
