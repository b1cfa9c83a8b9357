package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntFunction;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.plan.UnservedWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;

/** Converts the search's order of waypoints for each drone to a plan with times, heights and energy. Never changes. */
final class PlanWriter {
    private final PlanningProblem problem;
    private final DroneTypes fleet;
    private final TourLegWriter ways;

    PlanWriter(PlanningProblem problem, DroneTypes fleet, TourLegWriter ways) {
        this.problem = problem;
        this.fleet = fleet;
        this.ways = ways;
    }

    /**
     * Each drone sets off as soon as it can, and flies only if it visits something or is in the air.
     *
     * @param orders of each drone, by waypoints' numbers
     * @param why a waypoint is in none of them
     */
    Plan write(int[][] orders, IntFunction<String> why) {
        BitSet served = new BitSet();
        List<Tour> tours = new ArrayList<>();
        for (int drone = 0; drone < orders.length; drone++) {
            for (int waypoint : orders[drone]) {
                served.set(waypoint);
            }
            Craft craft = problem.crafts().get(drone);
            if (orders[drone].length > 0 || craft.start().airborne()) {
                tours.add(tour(drone, orders[drone]));
            }
        }
        List<UnservedWaypoint> unserved = new ArrayList<>();
        for (int i = served.nextClearBit(0); i < problem.waypoints().size(); i = served.nextClearBit(i + 1)) {
            unserved.add(new UnservedWaypoint(problem.waypoints().get(i).id(), why.apply(i)));
        }
        return new Plan(tours, unserved);
    }

    private Tour tour(int drone, int[] order) {
        Craft craft = problem.crafts().get(drone);
        double hoverWatts = fleet.paceOf(drone).hoverWatts();
        double seconds = craft.start().readySeconds();
        double joules = craft.start().airborne() ? seconds * hoverWatts : 0;
        List<TourStop> stops = new ArrayList<>(order.length);
        int at = problem.waypoints().size() + 2 * drone;
        int end = at + 1;
        for (int next : order) {
            Waypoint waypoint = problem.waypoints().get(next);
            TourLeg way = ways.write(drone, at, next, seconds);
            double begins = Math.max(way.arrivesSeconds(), waypoint.window().opensSeconds());
            seconds = begins + waypoint.task().serviceSeconds();
            joules += way.joules() + (seconds - way.arrivesSeconds()) * hoverWatts;
            stops.add(new TourStop(waypoint.id(), way, begins, seconds, joules));
            at = next;
        }
        TourLeg last = ways.write(drone, at, end, seconds);
        return new Tour(craft.id(), stops, last, joules + last.joules());
    }
}
