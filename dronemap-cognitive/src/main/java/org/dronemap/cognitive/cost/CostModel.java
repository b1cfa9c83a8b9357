package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;

/**
 * Converts a planning problem to an allocation problem in numbers, and the orders found for it back to a plan. Safe for
 * several threads.
 */
public final class CostModel {
    private static final String CROWDED_OUT =
            "No drone has time, or charge, to serve it besides what the plan gives it to do.";

    /** So many waypoints times drones are looked at one by one before the search, else as if no zone were in the way. */
    private static final int MOST_LOOKED_AT = 20_000;

    private final PlanningProblem problem;
    private final AllocationProblem instance;
    private final WaypointFeasibility feasibility;
    private final PlanWriter writer;

    private CostModel(
            PlanningProblem problem, AllocationProblem instance, WaypointFeasibility feasibility, PlanWriter writer) {
        this.problem = problem;
        this.instance = instance;
        this.feasibility = feasibility;
        this.writer = writer;
    }

    public static CostModel of(PlanningProblem problem) {
        PlaceTable track = new PlaceTable(problem);
        DroneTypes fleet = DroneTypes.of(problem);
        DirectLegs open = new DirectLegs(track, fleet.paces());
        FencedLegs fenced = problem.barriers().isEmpty() ? null : fenced(problem, track, fleet, open);
        Legs legs = fenced == null ? open : fenced;
        Detours detours = fenced == null ? Detours.NONE : fenced;
        boolean small = (long) problem.waypoints().size() * problem.crafts().size() <= MOST_LOOKED_AT;
        double[] ranges = ranges(problem);
        WaypointFeasibility feasibility = new WaypointFeasibility(problem, fleet, small ? legs : open, detours, ranges);
        AllocationProblem instance = new AllocationProblem(
                legs, visits(problem, fleet, feasibility), carriers(problem, fleet, ranges), aim(problem.objective()));
        TourLegWriter ways = new TourLegWriter(problem, track, fleet, detours);
        return new CostModel(problem, instance, feasibility, new PlanWriter(problem, fleet, ways));
    }

    private static FencedLegs fenced(PlanningProblem problem, PlaceTable track, DroneTypes fleet, DirectLegs open) {
        Map<DroneTypes.BarrierSet, BarrierMap> known = new HashMap<>();
        List<BarrierMap> surroundings = fleet.regions().stream()
                .map(region -> known.computeIfAbsent(region, fresh -> new BarrierMap(fresh, track, problem.rules())))
                .toList();
        return new FencedLegs(track, open, fleet.paces(), surroundings);
    }

    public PlanningProblem problem() {
        return problem;
    }

    public AllocationProblem instance() {
        return instance;
    }

    /** Why no drone at all can visit a waypoint, as a sentence; empty when one could. */
    public Optional<String> whyNobody(int waypoint) {
        return instance.visits().get(waypoint).drones().isEmpty() ? feasibility.whyNobody(waypoint) : Optional.empty();
    }

    /**
     * The plan that a search has found.
     *
     * @param orders for each drone the numbers of its waypoints; those in none of them are unserved
     */
    public Plan plan(int[][] orders) {
        return writer.write(orders, waypoint -> whyNobody(waypoint).orElse(CROWDED_OUT));
    }

    /** Hovering till it is ready takes from what it may draw. */
    private static double[] ranges(PlanningProblem problem) {
        return problem.crafts().stream()
                .mapToDouble(craft -> {
                    double waiting = craft.start().airborne() ? craft.start().readySeconds() : 0;
                    return craft.supply().rangeJoules()
                            - waiting * craft.performance().power().hover();
                })
                .toArray();
    }

    private static List<AllocationWaypoint> visits(
            PlanningProblem problem, DroneTypes fleet, WaypointFeasibility feasibility) {
        double hoverWatts = 0;
        for (FlightModel pace : fleet.paces()) {
            hoverWatts = Math.max(hoverWatts, pace.hoverWatts());
        }
        List<AllocationWaypoint> visits = new ArrayList<>(problem.waypoints().size());
        for (int i = 0; i < problem.waypoints().size(); i++) {
            Waypoint waypoint = problem.waypoints().get(i);
            BitSet drones = feasibility.drones(i);
            visits.add(new AllocationWaypoint(
                    waypoint.task().serviceSeconds(),
                    hoverWatts,
                    waypoint.priority(),
                    waypoint.window().opensSeconds(),
                    waypoint.window().closesSeconds(),
                    drones));
        }
        return visits;
    }

    private static List<AllocationDrone> carriers(PlanningProblem problem, DroneTypes fleet, double[] ranges) {
        List<AllocationDrone> carriers = new ArrayList<>(ranges.length);
        for (int drone = 0; drone < ranges.length; drone++) {
            Craft craft = problem.crafts().get(drone);
            carriers.add(new AllocationDrone(
                    fleet.typeOf(drone),
                    craft.start().readySeconds(),
                    Math.max(0, ranges[drone]),
                    craft.start().airborne()));
        }
        return carriers;
    }

    private static AllocationObjective aim(Objective objective) {
        return new AllocationObjective(
                objective.longestWeight(),
                AllocationObjective.Measure.valueOf(objective.measure().name()),
                objective.sumWeight(),
                objective.everyDrone());
    }
}
