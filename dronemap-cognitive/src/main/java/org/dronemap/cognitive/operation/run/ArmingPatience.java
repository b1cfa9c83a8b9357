package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.core.command.ArmingRetry;
import org.dronemap.core.command.Outcome;

/** Tries a drone of a mission run again that refuses to be armed yet, or to take the mode for it, before it leaves. */
final class ArmingPatience {
    private ArmingPatience() {}

    static boolean isFor(RunDrone drone, IssuedCommand errand, Outcome outcome) {
        boolean arms = errand.kind() == IssuedCommand.Purpose.ARM || errand.kind() == IssuedCommand.Purpose.MODE;
        return drone.stage() == RunDroneStage.ARMING && arms && ArmingRetry.mayPass(outcome);
    }

    /** Another try a moment later; when it was refused for too long, it leaves with its last reason. */
    static void refused(RunTransition draft, RunDrone drone, String why) {
        Instant first = drone.attempts().refusedSince();
        Instant since = first == null ? draft.now() : first;
        if (Duration.between(since, draft.now()).compareTo(ArmingRetry.LONGEST) >= 0) {
            String words =
                    drone.name() + " could not be armed for " + ArmingRetry.LONGEST.toSeconds() + " s: " + why + ".";
            DroneWithdrawal.callHome(draft, drone, RunTrigger.COMMAND_FAILED, words);
            return;
        }
        String words = drone.name() + " cannot be armed yet: " + why + ". It is tried again for "
                + ArmingRetry.LONGEST.toSeconds() + " s at most.";
        draft.put(drone.noted(words)
                .tried(new RunDrone.Attempts(
                        drone.attempts().failed(), draft.now().plus(ArmingRetry.PAUSE), since)));
        if (first == null) {
            draft.explain(RunTrigger.COMMAND_FAILED, drone.id(), words);
        }
    }
}
