package org.dronemap.bench.planning.library;

import com.graphhopper.jsprit.core.algorithm.VehicleRoutingAlgorithm;
import com.graphhopper.jsprit.core.algorithm.box.Jsprit;
import com.graphhopper.jsprit.core.algorithm.listener.IterationEndsListener;
import com.graphhopper.jsprit.core.algorithm.state.StateManager;
import com.graphhopper.jsprit.core.problem.Location;
import com.graphhopper.jsprit.core.problem.VehicleRoutingProblem;
import com.graphhopper.jsprit.core.problem.constraint.ConstraintManager;
import com.graphhopper.jsprit.core.problem.constraint.SoftRouteConstraint;
import com.graphhopper.jsprit.core.problem.job.Service;
import com.graphhopper.jsprit.core.problem.solution.VehicleRoutingProblemSolution;
import com.graphhopper.jsprit.core.problem.solution.route.VehicleRoute;
import com.graphhopper.jsprit.core.problem.vehicle.VehicleImpl;
import com.graphhopper.jsprit.core.problem.vehicle.VehicleTypeImpl;
import com.graphhopper.jsprit.core.util.FastVehicleRoutingTransportCostsMatrix;
import java.util.Collection;
import java.util.Random;
import java.util.function.Consumer;
import org.dronemap.bench.planning.Solver;
import org.dronemap.bench.planning.TourProblem;

/** jsprit: its ruin-and-recreate strategies, with a threshold that sinks with the CPU used. */
public final class JspritSolver implements Solver {
    /** What the sum of all tours counts beside the longest, shared by the drones. */
    private static final double SUM_WEIGHT = 0.2;
    /** How much the length of a tour counts against it when a waypoint is put in: with less the first plan is one long tour. */
    private static final double BALANCE = 1;
    /** With regret insertion the first plan of more waypoints takes longer than the search is given. */
    private static final int MOST_REGRETTED = 250;

    @Override
    public String about() {
        return "jsprit: all its strategies, fast regret (best insertion above " + MOST_REGRETTED + " waypoints), "
                + "threshold accepting over the CPU used, longest tour + " + SUM_WEIGHT + " of the mean";
    }

    @Override
    public int[][] solve(TourProblem problem, SearchOptions order, Consumer<int[][]> improved) {
        if (!problem.longest()) {
            throw new IllegalArgumentException("set up for the longest tour only");
        }
        VehicleRoutingProblem routing = routing(problem);
        VehicleRoutingAlgorithm algorithm = algorithm(problem, routing, order);
        algorithm.setPrematureAlgorithmTermination(solution -> order.allowance().isSpent());
        double[] best = {Double.POSITIVE_INFINITY};
        algorithm.addListener((IterationEndsListener) (iteration, same, solutions) -> {
            for (VehicleRoutingProblemSolution solution : solutions) {
                if (solution.getCost() < best[0]) {
                    best[0] = solution.getCost();
                    improved.accept(orders(problem, solution));
                }
            }
        });
        Collection<VehicleRoutingProblemSolution> found = algorithm.searchSolutions();
        int[][] shortest = new int[problem.drones()][0];
        double least = Double.POSITIVE_INFINITY;
        for (VehicleRoutingProblemSolution solution : found) {
            int[][] orders = orders(problem, solution);
            if (problem.value(orders) < least) {
                least = problem.value(orders);
                shortest = orders;
            }
        }
        return shortest;
    }

    private static VehicleRoutingProblem routing(TourProblem problem) {
        VehicleRoutingProblem.Builder builder = VehicleRoutingProblem.Builder.newInstance()
                .setFleetSize(VehicleRoutingProblem.FleetSize.FINITE)
                .setRoutingCost(costs(problem));
        VehicleTypeImpl type =
                VehicleTypeImpl.Builder.newInstance("drone").setFixedCost(0).build();
        for (int drone = 0; drone < problem.drones(); drone++) {
            builder.addVehicle(VehicleImpl.Builder.newInstance(Integer.toString(drone))
                    .setType(type)
                    .setStartLocation(Location.newInstance(problem.depot(drone)))
                    .build());
        }
        for (int waypoint = 0; waypoint < problem.waypoints().size(); waypoint++) {
            builder.addJob(Service.Builder.newInstance(Integer.toString(waypoint))
                    .setLocation(Location.newInstance(waypoint))
                    .build());
        }
        return builder.build();
    }

    private static FastVehicleRoutingTransportCostsMatrix costs(TourProblem problem) {
        double[][] distances = problem.distances();
        FastVehicleRoutingTransportCostsMatrix.Builder costs =
                FastVehicleRoutingTransportCostsMatrix.Builder.newInstance(distances.length, true);
        for (int from = 0; from < distances.length; from++) {
            for (int to = 0; to <= from; to++) {
                costs.addTransportTimeAndDistance(from, to, distances[from][to], distances[from][to]);
            }
        }
        return costs.build();
    }

    private static VehicleRoutingAlgorithm algorithm(TourProblem problem, VehicleRoutingProblem routing, SearchOptions order) {
        StateManager states = new StateManager(routing);
        ConstraintManager constraints = new ConstraintManager(routing, states);
        constraints.addConstraint((SoftRouteConstraint) context -> BALANCE * length(context.getRoute()));
        VehicleRoutingAlgorithm algorithm = Jsprit.Builder.newInstance(routing)
                .setStateAndConstraintManager(states, constraints)
                .addCoreStateAndConstraintStuff(true)
                .setObjectiveFunction(solution -> cost(problem, solution))
                .setCustomAcceptor(new SinkingThreshold(order.allowance()))
                .setProperty(Jsprit.Parameter.FAST_REGRET, "true")
                .setProperty(
                        Jsprit.Parameter.CONSTRUCTION, construction(problem).toString())
                .setRandom(new Random(order.seed()))
                .buildAlgorithm();
        algorithm.setMaxIterations(Integer.MAX_VALUE);
        return algorithm;
    }

    private static Jsprit.Construction construction(TourProblem problem) {
        return problem.waypoints().size() > MOST_REGRETTED
                ? Jsprit.Construction.BEST_INSERTION
                : Jsprit.Construction.REGRET_INSERTION;
    }

    private static double cost(TourProblem problem, VehicleRoutingProblemSolution solution) {
        double longest = 0;
        double sum = 0;
        for (VehicleRoute route : solution.getRoutes()) {
            longest = Math.max(longest, length(route));
            sum += length(route);
        }
        // A waypoint left out must cost more than any tour that calls at it.
        return longest
                + SUM_WEIGHT * sum / problem.drones()
                + 1e9 * solution.getUnassignedJobs().size();
    }

    private static double length(VehicleRoute route) {
        return route.isEmpty()
                ? 0
                : route.getEnd().getArrTime() - route.getStart().getEndTime();
    }

    private static int[][] orders(TourProblem problem, VehicleRoutingProblemSolution solution) {
        int[][] orders = new int[problem.drones()][0];
        for (VehicleRoute route : solution.getRoutes()) {
            orders[Integer.parseInt(route.getVehicle().getId())] = route.getTourActivities().getActivities().stream()
                    .mapToInt(activity -> activity.getLocation().getIndex())
                    .toArray();
        }
        return orders;
    }
}
