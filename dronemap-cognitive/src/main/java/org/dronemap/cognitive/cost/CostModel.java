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
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Waypoint;

/** A problem in numbers, and the way back from an order of waypoints to a plan. Safe for several threads. */
public final class CostModel {
    private static final String CROWDED_OUT =
            "No drone has time, or charge, to serve it besides what the plan gives it to do.";

    /** So many waypoints times drones are looked at one by one before the search, else as if no zone were in the way. */
    private static final int MOST_LOOKED_AT = 20_000;

    private final Problem problem;
    private final Instance instance;
    private final Feasibility feasibility;
    private final PlanWriter writer;

    private CostModel(Problem problem, Instance instance, Feasibility feasibility, PlanWriter writer) {
        this.problem = problem;
        this.instance = instance;
        this.feasibility = feasibility;
        this.writer = writer;
    }

    public static CostModel of(Problem problem) {
        Track track = new Track(problem);
        Fleet fleet = Fleet.of(problem);
        OpenLegs open = new OpenLegs(track, fleet.paces());
        FencedLegs fenced = problem.barriers().isEmpty() ? null : fenced(problem, track, fleet, open);
        Legs legs = fenced == null ? open : fenced;
        Detours detours = fenced == null ? Detours.NONE : fenced;
        boolean small = (long) problem.waypoints().size() * problem.crafts().size() <= MOST_LOOKED_AT;
        double[] ranges = ranges(problem);
        Feasibility feasibility = new Feasibility(problem, fleet, small ? legs : open, detours, ranges);
        Instance instance = new Instance(
                legs, visits(problem, fleet, feasibility), carriers(problem, fleet, ranges), aim(problem.objective()));
        WayWriter ways = new WayWriter(problem, track, fleet, detours);
        return new CostModel(problem, instance, feasibility, new PlanWriter(problem, fleet, ways));
    }

    private static FencedLegs fenced(Problem problem, Track track, Fleet fleet, OpenLegs open) {
        Map<Fleet.Region, Surroundings> known = new HashMap<>();
        List<Surroundings> surroundings = fleet.regions().stream()
                .map(region -> known.computeIfAbsent(region, fresh -> new Surroundings(fresh, track, problem.rules())))
                .toList();
        return new FencedLegs(track, open, fleet.paces(), surroundings);
    }

    public Problem problem() {
        return problem;
    }

    public Instance instance() {
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
    private static double[] ranges(Problem problem) {
        return problem.crafts().stream()
                .mapToDouble(craft -> {
                    double waiting = craft.start().airborne() ? craft.start().readySeconds() : 0;
                    return craft.supply().rangeJoules()
                            - waiting * craft.performance().power().hover();
                })
                .toArray();
    }

    private static List<Visit> visits(Problem problem, Fleet fleet, Feasibility feasibility) {
        double hoverWatts = 0;
        for (Pace pace : fleet.paces()) {
            hoverWatts = Math.max(hoverWatts, pace.hoverWatts());
        }
        List<Visit> visits = new ArrayList<>(problem.waypoints().size());
        for (int i = 0; i < problem.waypoints().size(); i++) {
            Waypoint waypoint = problem.waypoints().get(i);
            BitSet drones = feasibility.drones(i);
            visits.add(new Visit(
                    waypoint.task().serviceSeconds(),
                    hoverWatts,
                    waypoint.priority(),
                    waypoint.window().opensSeconds(),
                    waypoint.window().closesSeconds(),
                    drones));
        }
        return visits;
    }

    private static List<Carrier> carriers(Problem problem, Fleet fleet, double[] ranges) {
        List<Carrier> carriers = new ArrayList<>(ranges.length);
        for (int drone = 0; drone < ranges.length; drone++) {
            Craft craft = problem.crafts().get(drone);
            carriers.add(new Carrier(
                    fleet.typeOf(drone),
                    craft.start().readySeconds(),
                    Math.max(0, ranges[drone]),
                    craft.start().airborne()));
        }
        return carriers;
    }

    private static Aim aim(Objective objective) {
        return new Aim(
                objective.longestWeight(),
                Aim.Measure.valueOf(objective.measure().name()),
                objective.sumWeight(),
                objective.everyDrone());
    }
}
