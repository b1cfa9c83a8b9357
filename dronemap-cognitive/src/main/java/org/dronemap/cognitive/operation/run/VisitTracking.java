package org.dronemap.cognitive.operation.run;

import java.util.List;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;

/** Marks waypoints as visited by the mission progress that drones report. */
final class VisitTracking {
    private VisitTracking() {}

    static void update(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        Sortie sortie = drone.sortie();
        boolean tells =
                look.isLive() && !Boolean.FALSE.equals(look.progress().carries()) && !FlightHealth.tumbles(drone, look);
        if (sortie == null || !tells || !(counts(drone) || isFlownToItsEnd(drone, look))) {
            return;
        }
        pass(draft, drone, look, sortie);
        TaskReports.update(draft, draft.drone(look.drone()), look);
    }

    private static void pass(RunTransition draft, RunDrone drone, DroneObservation look, Sortie sortie) {
        int items = sortie.mission().items().size();
        int passed = look.progress().complete()
                ? items
                : Math.min(items, look.progress().passed());
        if (passed <= drone.passed()) {
            return;
        }
        draft.put(drone.withSortie(sortie, passed));
        List<String> known = sortie.done(drone.passed());
        sortie.done(passed).stream().filter(id -> !known.contains(id)).forEach(id -> visited(draft, drone, id));
    }

    /** While a mission is being brought to it, what it says may be of the one before or of the next. */
    private static boolean counts(RunDrone drone) {
        return drone.flags().begun()
                && switch (drone.stage()) {
                    case FLYING, HOLDING, RETURNING, SILENT, SUSPENDED, GONE, LEFT -> true;
                    default -> false;
                };
    }

    /** It was told to go on when the cloud went away, and stands on the ground now: what it carries is all behind it. */
    private static boolean isFlownToItsEnd(RunDrone drone, DroneObservation look) {
        return drone.stage() == RunDroneStage.CONTINUING
                && Boolean.TRUE.equals(look.progress().carries())
                && look.progress().complete()
                && look.isDisarmed();
    }

    private static void visited(RunTransition draft, RunDrone drone, String id) {
        RunWaypoint target = draft.target(id);
        if (target.state() == RunWaypoint.State.CANCELLED) {
            return;
        }
        boolean again = !target.visits().isEmpty();
        RunWaypoint visited = target.visited(drone.id(), draft.now());
        if (visited.equals(target)) {
            return;
        }
        draft.put(visited);
        draft.drones().stream()
                .filter(any -> any.orders().contains(id))
                .forEach(any -> draft.put(any.withOrders(
                        any.orders().stream().filter(other -> !other.equals(id)).toList())));
        if (again) {
            draft.tally().countRepeatedVisit();
            draft.explain(
                    RunTrigger.HEARD_AGAIN,
                    drone.id(),
                    "The waypoint " + id + " was visited twice: by " + name(draft, target) + ", and by " + drone.name()
                            + ", which was out of contact.");
        }
    }

    private static String name(RunTransition draft, RunWaypoint target) {
        return draft.drone(target.visits().get(0).drone()).name();
    }
}
