package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;

/** Applies the outcome of a command to the drone of a mission run that it was given to. */
final class RunCommandResults {
    private static final int MOST_TRIES = 3;
    private static final Duration BETWEEN_TRIES = Duration.ofSeconds(2);
    private static final Duration BETWEEN_DODGES = Duration.ofSeconds(1);

    private RunCommandResults() {}

    static void ended(RunTransition draft, RunInput.CommandEnded input) {
        if (!draft.knows(input.drone())) {
            return;
        }
        RunDrone drone = draft.drone(input.drone());
        IssuedCommand errand = drone.issuedCommand();
        if (errand == null || !errand.command().equals(input.command())) {
            return;
        }
        if (input.outcome() instanceof Outcome.Succeeded) {
            succeeded(draft, drone.withIssuedCommand(null), errand);
        } else if (errand.kind() == IssuedCommand.Purpose.HEIGHT) {
            ReturnHeightOverride.failed(draft, drone.withIssuedCommand(null), reason(input.outcome()));
        } else if (errand.kind() == IssuedCommand.Purpose.DODGE) {
            // Another step is looked for, from where it is then.
            draft.put(drone.tried(
                    new RunDrone.Attempts(drone.attempts().failed(), draft.now().plus(BETWEEN_DODGES))));
        } else if (drone.stage() == RunDroneStage.RETURNING) {
            // It is called again until it comes.
            draft.put(drone.withIssuedCommand(null));
        } else if (ArmingPatience.isFor(drone, errand, input.outcome())) {
            ArmingPatience.refused(draft, drone, reason(input.outcome()));
        } else if (errand.kind() != IssuedCommand.Purpose.UPLOAD || !refusesAnItem(draft, drone, input.outcome())) {
            failed(draft, drone, reason(input.outcome()));
        }
    }

    private static boolean refusesAnItem(RunTransition draft, RunDrone drone, Outcome outcome) {
        OutcomeCode code = outcome.code();
        return code != null
                && UnflyableWaypoints.foundByVehicle(draft, drone.withIssuedCommand(null), code, reason(outcome) + ".");
    }

    private static void succeeded(RunTransition draft, RunDrone drone, IssuedCommand errand) {
        Sortie next = drone.next();
        switch (errand.kind()) {
            case UPLOAD ->
                draft.put(
                        next == null || next.number() != errand.sortie()
                                ? drone
                                : uploaded(RunCommands.uploaded(drone, next), draft.now()));
            case HEIGHT -> ReturnHeightOverride.succeeded(draft, drone);
            case START -> draft.put(onTime(drone, draft.now()).to(RunDroneStage.FLYING, draft.now()));
            default -> draft.put(drone);
        }
    }

    /** One that waits for another drone to pass goes on doing so. */
    private static RunDrone uploaded(RunDrone drone, Instant now) {
        return switch (drone.stage()) {
            case HOLDING -> drone;
            case REPLACING -> drone.to(RunDroneStage.CONTINUING, now);
            default -> drone.to(RunDroneStage.READY, now);
        };
    }

    /** Over a bad link a mission takes a minute to come on board: who begins it then is not late. */
    private static RunDrone onTime(RunDrone drone, Instant now) {
        Sortie sortie = drone.sortie();
        return sortie == null || drone.passed() > 0 ? drone : drone.withSortie(sortie.departingAt(now), drone.passed());
    }

    static void failed(RunTransition draft, RunDrone drone, String why) {
        int failed = drone.attempts().failed() + 1;
        if (failed < MOST_TRIES) {
            draft.put(drone.tried(new RunDrone.Attempts(failed, draft.now().plus(BETWEEN_TRIES))));
            return;
        }
        String words = drone.name() + " could not be made to go on: " + why + ".";
        boolean mayFly = drone.stage().mayFly();
        if (mayFly || drone.stage() == RunDroneStage.ARMING) {
            DroneWithdrawal.callHome(draft, drone, RunTrigger.COMMAND_FAILED, words);
        } else {
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.LEFT, RunTrigger.COMMAND_FAILED, words);
        }
    }

    private static String reason(Outcome outcome) {
        String why = outcome.reason();
        return why == null ? "" : trimmed(why);
    }

    private static String trimmed(String sentence) {
        return sentence.endsWith(".") ? sentence.substring(0, sentence.length() - 1) : sentence;
    }
}
