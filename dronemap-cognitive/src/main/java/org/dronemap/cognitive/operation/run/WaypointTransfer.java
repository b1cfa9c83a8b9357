package org.dronemap.cognitive.operation.run;

import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.TourStop;

/** Keeps a waypoint that passes from one drone of a mission run to another from being flown to by both. */
final class WaypointTransfer {
    private WaypointTransfer() {}

    /** Whether nobody else who is under way still heads for what it is to get. */
    static boolean isFree(RunTransition draft, RunDrone drone, Sortie next) {
        List<String> wanted =
                next.tour().stops().stream().map(TourStop::waypoint).toList();
        return draft.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && isUnderWay(other))
                .noneMatch(other -> other.sortie() != null
                        && other.sortie().ahead(other.passed()).stream().anyMatch(wanted::contains));
    }

    /** It flies what it has on board; a drone that is not heard is nobody to wait for. */
    private static boolean isUnderWay(RunDrone drone) {
        boolean holds = drone.issuedCommand() == null && drone.attempts().failed() == 0;
        return switch (drone.stage()) {
            case STARTING, FLYING, CONTINUING -> true;
            case HOLDING -> !holds;
            default -> false;
        };
    }

    /** Whether it has something on board that is not its own any more. */
    static boolean gives(RunDrone drone, Sortie next) {
        List<String> kept = next.tour().stops().stream().map(TourStop::waypoint).toList();
        Sortie sortie = drone.sortie();
        return sortie != null && !kept.containsAll(sortie.ahead(drone.passed()));
    }
}
