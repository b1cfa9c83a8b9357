package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;

/** Ends a mission run when all drones are at rest and nothing is left to do. */
final class RunCompletion {
    private RunCompletion() {}

    static void close(RunTransition draft) {
        boolean busy = draft.request() != null
                || draft.causes().stream().anyMatch(cause -> !cause.isBetter())
                || draft.proposal() != null;
        boolean rest = draft.drones().stream().allMatch(RunCompletion::isAtRest);
        if (busy || !rest) {
            return;
        }
        boolean open =
                draft.targets().stream().anyMatch(target -> !target.state().isSettled());
        boolean mayGoOn = draft.drones().stream().anyMatch(drone -> drone.stage() == RunDroneStage.SUSPENDED);
        if (open && (mayGoOn || RunPoolDrones.mayJoin(draft) || DroneObstacles.isWaitedFor(draft))) {
            return;
        }
        for (RunWaypoint target : draft.targets()) {
            if (!target.state().isSettled()) {
                String why = target.reason() == null ? RunPoolDrones.leftover(draft) : target.reason();
                draft.put(target.to(RunWaypoint.State.UNSERVED, null, why));
            }
        }
        String words = words(draft);
        draft.explain(RunTrigger.ENDED, null, words);
        draft.end(words);
    }

    private static boolean isAtRest(RunDrone drone) {
        return drone.stage().isAtRest() && drone.next() == null && drone.issuedCommand() == null;
    }

    private static String words(RunTransition draft) {
        List<RunWaypoint> targets = draft.targets().stream()
                .filter(target -> target.state() != RunWaypoint.State.CANCELLED)
                .toList();
        long visited = targets.stream()
                .filter(target -> target.state() == RunWaypoint.State.VISITED)
                .count();
        List<String> parts = new ArrayList<>();
        parts.add(
                visited == targets.size()
                        ? "The run is over: all " + RunMessages.count(visited, "waypoint") + " visited."
                        : "The run is over: " + visited + " of " + RunMessages.count(targets.size(), "waypoint")
                                + " visited, without "
                                + RunMessages.list(targets.stream()
                                        .filter(target -> target.state() != RunWaypoint.State.VISITED)
                                        .map(RunWaypoint::id)
                                        .toList())
                                + ".");
        int doubles = draft.tally().counts().doubles();
        if (doubles > 0) {
            parts.add(RunMessages.count(doubles, "visit") + " too many, by drones out of contact.");
        }
        draft.drones().stream()
                .map(HomeArrival::leftoverNotice)
                .filter(Objects::nonNull)
                .forEach(parts::add);
        draft.drones().stream()
                .map(ReturnHeightOverride::leftoverNotice)
                .filter(Objects::nonNull)
                .forEach(parts::add);
        return String.join(" ", parts);
    }
}
