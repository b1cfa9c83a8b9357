package org.dronemap.bench.planning.library;

import com.google.ortools.Loader;
import com.google.ortools.constraintsolver.Assignment;
import com.google.ortools.constraintsolver.LocalSearchMetaheuristic;
import com.google.ortools.constraintsolver.RoutingDimension;
import com.google.ortools.constraintsolver.RoutingIndexManager;
import com.google.ortools.constraintsolver.RoutingModel;
import com.google.ortools.constraintsolver.RoutingSearchParameters;
import com.google.ortools.constraintsolver.main;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongUnaryOperator;
import java.util.stream.IntStream;
import org.dronemap.bench.planning.BaselineSolver;
import org.dronemap.bench.planning.Solver;
import org.dronemap.bench.planning.TourProblem;
import org.dronemap.cognitive.allocate.NearestNeighbourBaseline;

/**
 * OR-Tools' routing library: a span cost makes the longest tour count, guided local search goes on from tours that share
 * the waypoints already, as its own first solutions put nearly all of them into one.
 */
public final class OrToolsSolver implements Solver {
    private static final long SPAN_WEIGHT = 100;
    /** Distances become whole numbers; the longest has so many steps. */
    private static final double STEPS = 1e7;

    @Override
    public String about() {
        return "OR-Tools routing: nearest-neighbour tours, guided local search, global span cost " + SPAN_WEIGHT;
    }

    @Override
    public int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved) {
        if (!problem.longest()) {
            throw new IllegalArgumentException("set up for the longest tour only");
        }
        Loader.loadNativeLibraries();
        int[] depots = IntStream.range(0, problem.drones()).map(problem::depot).toArray();
        RoutingIndexManager manager = new RoutingIndexManager(problem.places(), problem.drones(), depots, depots);
        RoutingModel model = new RoutingModel(manager);
        int transit = model.registerTransitMatrix(steps(problem));
        model.setArcCostEvaluatorOfAllVehicles(transit);
        model.addDimension(transit, 0, Long.MAX_VALUE / 1000, true, "length");
        RoutingDimension length = model.getMutableDimension("length");
        length.setGlobalSpanCostCoefficient(SPAN_WEIGHT);
        model.addSearchMonitor(
                model.solver().makeCustomLimit(() -> order.allowance().isSpent()));
        model.addAtSolutionCallback(() -> improved.accept(current(problem, manager, model)));
        RoutingSearchParameters parameters = main.defaultRoutingSearchParameters().toBuilder()
                .setLocalSearchMetaheuristic(LocalSearchMetaheuristic.Value.GUIDED_LOCAL_SEARCH)
                .build();
        model.closeModelWithParameters(parameters);
        Assignment first = model.readAssignmentFromRoutes(first(problem), true);
        Assignment found = model.solveFromAssignmentWithParameters(first, parameters);
        return tours(problem, manager, model, found);
    }

    private static long[][] steps(TourProblem problem) {
        double[][] distances = problem.distances();
        double longest =
                Arrays.stream(distances).flatMapToDouble(Arrays::stream).max().orElse(1);
        double scale = STEPS / longest;
        return Arrays.stream(distances)
                .map(row -> Arrays.stream(row)
                        .mapToLong(distance -> Math.round(distance * scale))
                        .toArray())
                .toArray(long[][]::new);
    }

    private static long[][] first(TourProblem problem) {
        int[][] orders = new BaselineSolver("", new NearestNeighbourBaseline()).orders(problem);
        return Arrays.stream(orders)
                .map(order -> Arrays.stream(order).asLongStream().toArray())
                .toArray(long[][]::new);
    }

    /** While the search goes on. */
    private static int[][] current(TourProblem problem, RoutingIndexManager manager, RoutingModel model) {
        return walk(problem, manager, model, index -> model.nextVar(index).value());
    }

    private static int[][] tours(
            TourProblem problem, RoutingIndexManager manager, RoutingModel model, Assignment found) {
        return walk(problem, manager, model, index -> found.value(model.nextVar(index)));
    }

    private static int[][] walk(
            TourProblem problem, RoutingIndexManager manager, RoutingModel model, LongUnaryOperator next) {
        int[][] orders = new int[problem.drones()][];
        for (int drone = 0; drone < orders.length; drone++) {
            List<Integer> order = new ArrayList<>();
            long index = next.applyAsLong(model.start(drone));
            while (!model.isEnd(index)) {
                order.add(manager.indexToNode(index));
                index = next.applyAsLong(index);
            }
            orders[drone] = order.stream().mapToInt(Integer::intValue).toArray();
        }
        return orders;
    }
}
