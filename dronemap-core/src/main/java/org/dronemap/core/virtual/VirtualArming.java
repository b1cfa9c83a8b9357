package org.dronemap.core.virtual;

import static org.dronemap.core.virtual.VirtualRunStage.STARTING;

import java.time.Duration;
import java.util.Optional;
import org.dronemap.core.command.ArmingRetry;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.GiveWay;

/** Arms the drone of a virtual drone's run, and waits for one that cannot be armed yet. */
final class VirtualArming {
    private VirtualArming() {}

    static VirtualRunStep next(
            VirtualRun run, VirtualRunAssignment assignment, DroneState drone, VirtualRunObservation sight) {
        Outcome outcome = sight.outcome();
        if (Boolean.TRUE.equals(drone.armed())) {
            return VirtualRunStep.unchanged(run.to(STARTING, assignment.tries(), "The drone starts.", sight.now()));
        }
        if (outcome != null && isWaitedFor(run, outcome, sight)) {
            return VirtualRunStep.unchanged(run.waiting(
                    "The drone cannot be armed yet; it is tried again for " + ArmingRetry.LONGEST.toSeconds()
                            + " s at most.",
                    VirtualRunMachine.reason(outcome),
                    sight.now()));
        }
        if (outcome != null && !(outcome instanceof Outcome.Succeeded)) {
            return VirtualRunMachine.tryAgain(run, assignment, drone, sight);
        }
        boolean refusedJustNow = run.detail() != null
                && assignment.command() == null
                && Duration.between(assignment.changedAt(), sight.now()).compareTo(ArmingRetry.PAUSE) < 0;
        boolean wait = refusedJustNow || !wasLookedAt(run, sight);
        return wait ? VirtualRunStep.unchanged(run) : VirtualRunStep.send(run, order(drone));
    }

    private static boolean wasLookedAt(VirtualRun run, VirtualRunObservation sight) {
        return Duration.between(run.changedAt(), sight.now()).compareTo(GiveWay.SHOWN_AFTER) >= 0;
    }

    /** From when it came to be armed on. */
    private static boolean isWaitedFor(VirtualRun run, Outcome outcome, VirtualRunObservation sight) {
        return ArmingRetry.mayPass(outcome)
                && Duration.between(run.changedAt(), sight.now()).compareTo(ArmingRetry.LONGEST) < 0;
    }

    /** After a flight it may stand in a mode in which it cannot be armed. */
    private static Command order(DroneState drone) {
        boolean takesOrders = drone.capabilities().steering(drone.mode()).equals(Optional.of(Steering.ORDERS));
        Optional<String> mode =
                takesOrders ? Optional.empty() : drone.capabilities().mode(Steering.ORDERS);
        return mode.<Command>map(Command.SetMode::new).orElseGet(Command.Arm::new);
    }
}
