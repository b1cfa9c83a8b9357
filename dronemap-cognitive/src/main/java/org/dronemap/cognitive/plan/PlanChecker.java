package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;

/** Checks a plan against its problem by calculations of its own, independent of the planner's. */
public final class PlanChecker {
    private PlanChecker() {}

    /** Each a sentence; nothing when the plan can be flown. */
    public static List<String> faults(PlanningProblem problem, Plan plan) {
        List<String> faults = new ArrayList<>();
        visits(problem, plan, faults);
        Map<DroneId, Craft> crafts =
                problem.crafts().stream().collect(Collectors.toMap(Craft::id, Function.identity()));
        Map<String, Waypoint> waypoints =
                problem.waypoints().stream().collect(Collectors.toMap(Waypoint::id, Function.identity()));
        Map<DroneId, Tour> flown = new HashMap<>();
        for (Tour tour : plan.tours()) {
            Craft craft = crafts.get(tour.drone());
            if (craft == null) {
                faults.add("The drone " + tour.drone() + " has a tour and is not part of the problem.");
            } else if (flown.putIfAbsent(tour.drone(), tour) != null) {
                faults.add("The drone " + tour.drone() + " has two tours.");
            } else {
                new TourCheck(problem, craft, tour, faults).judge(waypoints);
            }
        }
        idle(problem, flown, faults);
        SeparationCheck.conflicts(problem, plan).forEach(conflict -> faults.add(conflict.words()));
        return List.copyOf(faults);
    }

    private static void idle(PlanningProblem problem, Map<DroneId, Tour> flown, List<String> faults) {
        for (Craft craft : problem.crafts()) {
            Tour tour = flown.get(craft.id());
            if (tour == null && craft.start().airborne()) {
                faults.add("The drone " + craft.id() + " is in the air and has no tour to its end.");
            } else if (problem.objective().everyDrone()
                    && problem.trusts(craft)
                    && (tour == null || tour.stops().isEmpty())) {
                faults.add("The drone " + craft.id() + " visits nothing, and every drone must.");
            }
        }
    }

    private static void visits(PlanningProblem problem, Plan plan, List<String> faults) {
        Set<String> seen = new HashSet<>();
        plan.tours().stream().flatMap(tour -> tour.stops().stream()).forEach(stop -> {
            if (!seen.add(stop.waypoint())) {
                faults.add("The waypoint " + stop.waypoint() + " is visited twice.");
            }
        });
        for (UnservedWaypoint unserved : plan.unserved()) {
            if (!seen.add(unserved.waypoint())) {
                faults.add("The waypoint " + unserved.waypoint() + " is both visited and unserved, or unserved twice.");
            }
            if (unserved.why().isBlank()) {
                faults.add("The waypoint " + unserved.waypoint() + " is unserved without a reason.");
            }
        }
        for (Waypoint waypoint : problem.waypoints()) {
            if (!seen.remove(waypoint.id())) {
                faults.add("The waypoint " + waypoint.id() + " is neither visited nor unserved.");
            }
        }
        seen.stream().sorted().forEach(id -> faults.add("The waypoint " + id + " is not part of the problem."));
    }
}
