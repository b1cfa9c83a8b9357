package org.dronemap.cognitive.operation.run;

import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;

/** Withdraws a drone from its part in a mission run, and offers its unvisited waypoints to the other drones. */
final class DroneWithdrawal {
    private DroneWithdrawal() {}

    static void withdraw(RunTransition draft, RunDrone drone, RunDroneStage stage, RunTrigger trigger, String words) {
        withdraw(draft, drone, stage, trigger, words, words);
    }

    /** {@code note}: what is shown of it from now on. */
    static void withdraw(
            RunTransition draft, RunDrone drone, RunDroneStage stage, RunTrigger trigger, String words, String note) {
        boolean had = !drone.orders().isEmpty();
        RunDrone out = draft.release(drone, words).noted(note).to(stage, draft.now());
        boolean mayHover = stage == RunDroneStage.GONE && !draft.isWordedBefore(2);
        draft.put(out.with(out.flags()
                .fallingSince(null)
                .deviatingSince(null)
                .withLinkLoss(mayHover ? drone.flags().linkLoss() : null)
                .waitsFor(null)));
        if (had) {
            draft.addCause(trigger, drone.id(), words, drone.orders());
        } else {
            draft.explain(trigger, drone.id(), words);
        }
    }

    static void callHome(RunTransition draft, RunDrone drone, RunTrigger trigger, String words) {
        withdraw(draft, drone, RunDroneStage.RETURNING, trigger, words);
    }
}
