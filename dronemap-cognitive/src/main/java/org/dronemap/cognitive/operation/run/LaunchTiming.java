package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;

/** Decides when drones take off: after all missions are uploaded, each at the time of its plan. */
final class LaunchTiming {
    private LaunchTiming() {}

    /** Once all have their missions the plan's clock begins. */
    static void launchWhenReady(RunTransition draft) {
        boolean waits = draft.clock().launched()
                || draft.isPaused()
                || draft.request() != null
                || !draft.causes().isEmpty()
                || draft.drones().stream().anyMatch(drone -> drone.stage() == RunDroneStage.UPLOADING);
        if (waits || draft.drones().stream().noneMatch(drone -> drone.stage() == RunDroneStage.READY)) {
            return;
        }
        Instant now = draft.now();
        draft.clock(draft.clock().launched(now));
        for (RunDrone drone : draft.drones()) {
            Sortie sortie = drone.sortie();
            if (drone.stage() == RunDroneStage.READY && sortie != null) {
                draft.put(drone.withSortie(sortie.at(now), 0));
            }
        }
        long flying = draft.drones().stream()
                .filter(drone -> drone.stage() == RunDroneStage.READY)
                .count();
        draft.explain(RunTrigger.START, null, words(draft, flying));
    }

    private static String words(RunTransition draft, long flying) {
        if (draft.isWordedBefore(1)) {
            return "All missions are on board; " + RunMessages.count(flying, "drone") + " set off.";
        }
        return flying == 1
                ? "The mission of 1 drone is on board; it is armed and started at its time."
                : "The missions of " + flying + " drones are on board; each is armed and started at its time.";
    }

    static boolean isDue(RunTransition draft, Sortie sortie) {
        return isDue(draft.clock(), sortie, draft.now());
    }

    static boolean isDue(RunState.Clock clock, Sortie sortie, Instant now) {
        return clock.launched() && !now.isBefore(sortie.moment(sortie.tour().departsSeconds()));
    }
}
