package org.dronemap.cognitive.operation.run;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.replan.ReassignedWaypoint;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.drone.DroneId;

/**
 * Checks whether a re-planning still fits its mission run after what drones and waypoints did while it was computed.
 */
final class ReplanFreshness {
    private ReplanFreshness() {}

    static boolean isFresh(RunTransition draft, PendingReplan request, ReplanResult result) {
        Plan plan = result.plan();
        Map<String, DroneId> whose = new HashMap<>();
        plan.tours().forEach(tour -> tour.stops().forEach(stop -> whose.put(stop.waypoint(), tour.drone())));
        // What is taken at once from who flies to it was taken on purpose: its charge may not last for it.
        List<ReassignedWaypoint> taken =
                request.better() ? List.of() : result.changes().moved();
        return request.crafts().stream().allMatch(craft -> fits(draft.drone(craft.id()), craft, whose, taken))
                && plan.tours().stream()
                        .allMatch(tour -> tour.stops().stream().allMatch(stop -> isOpen(draft, tour.drone(), stop)));
    }

    private static boolean fits(
            RunDrone drone, Craft craft, Map<String, DroneId> whose, List<ReassignedWaypoint> taken) {
        boolean up = drone.stage().compareTo(RunDroneStage.STARTING) >= 0;
        if (!drone.stage().acceptsCommands() || up != craft.start().airborne()) {
            return false;
        }
        boolean heads = drone.stage() == RunDroneStage.FLYING && !drone.orders().isEmpty();
        DroneId then = heads ? whose.get(drone.orders().get(0)) : null;
        // One that is sent home does not come to what it flies to.
        return then == null
                || then.equals(drone.id())
                || !whose.containsValue(drone.id())
                || taken.stream().anyMatch(moved -> isHead(moved, drone));
    }

    private static boolean isHead(ReassignedWaypoint moved, RunDrone drone) {
        return drone.id().equals(moved.from())
                && moved.waypoint().equals(drone.orders().get(0));
    }

    /** Not done yet, or done by whom it is for. */
    private static boolean isOpen(RunTransition draft, DroneId drone, TourStop stop) {
        RunWaypoint target = draft.target(stop.waypoint());
        return switch (target.state()) {
            case WAITING -> true;
            case ASSIGNED -> true;
            case VISITED ->
                target.visits().stream().anyMatch(visit -> visit.drone().equals(drone));
            default -> false;
        };
    }

    /** Without what its drone has visited meanwhile. */
    static Tour remaining(RunTransition draft, Tour tour) {
        List<TourStop> stops = tour.stops().stream()
                .filter(stop -> !draft.target(stop.waypoint()).state().isSettled())
                .toList();
        return new Tour(tour.drone(), stops, tour.last(), tour.usedJoules());
    }

    /** What a drone has to visit by that plan. */
    static List<String> remaining(RunTransition draft, Plan plan, DroneId drone) {
        return plan.tours().stream()
                .filter(tour -> tour.drone().equals(drone))
                .flatMap(tour -> remaining(draft, tour).stops().stream())
                .map(TourStop::waypoint)
                .toList();
    }
}
