package org.dronemap.core.virtual;

import static org.dronemap.core.virtual.VirtualRunStage.ARMING;
import static org.dronemap.core.virtual.VirtualRunStage.FLYING;

import java.time.Duration;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.GiveWay;

/** Has the drone of a virtual drone's run wait while it gives way to another one, and sends it on afterwards. */
final class VirtualGivingWay {
    /** Before it is sent on once more. */
    private static final Duration BETWEEN_ORDERS = Duration.ofSeconds(4);

    private static final Duration LONGEST_WAIT = Duration.ofMinutes(3);

    private static final String ON_THE_GROUND = "The drone waits on the ground until another one has passed.";
    private static final String IN_THE_AIR = "The drone waits until another one has passed.";

    private VirtualGivingWay() {}

    /** Empty: it gives way to nobody, and does what its stage asks for. */
    static Optional<VirtualRunStep> next(VirtualRun run, DroneState drone, VirtualRunObservation sight) {
        GiveWay give = sight.giveWay();
        if (give == null) {
            return goesOn(run, sight);
        }
        return give.manner() == GiveWay.Manner.WAIT
                ? onTheGround(run, drone, sight)
                : inTheAir(run, drone, sight, give.clear());
    }

    private static Optional<VirtualRunStep> goesOn(VirtualRun run, VirtualRunObservation sight) {
        return run.stage() == FLYING && run.note().equals(IN_THE_AIR)
                ? Optional.of(VirtualRunStep.unchanged(run.withNote("The drone flies the mission.", sight.now())))
                : Optional.empty();
    }

    private static Optional<VirtualRunStep> onTheGround(VirtualRun run, DroneState drone, VirtualRunObservation sight) {
        return run.stage() == ARMING && !Boolean.TRUE.equals(drone.armed())
                ? Optional.of(VirtualRunStep.unchanged(run.withNote(ON_THE_GROUND, sight.now())))
                : Optional.empty();
    }

    private static Optional<VirtualRunStep> inTheAir(
            VirtualRun run, DroneState drone, VirtualRunObservation sight, boolean clear) {
        boolean stands = drone.capabilities()
                .steering(drone.mode())
                .filter(Steering::acceptsCommands)
                .isPresent();
        if (!drone.airborne() || (!stands && clear)) {
            return goesOn(run, sight);
        }
        if (!clear && isStuck(run, sight)) {
            return Optional.of(VirtualRunMachine.giveUp(
                    run, "Another drone does not leave the way; the drone is called home.", sight));
        }
        return Optional.of(
                clear && mayOrder(run, sight)
                        ? VirtualRunStep.send(run, onward(run, drone))
                        : VirtualRunStep.unchanged(run.withNote(IN_THE_AIR, sight.now())));
    }

    /** Its battery is not for waiting. */
    private static boolean isStuck(VirtualRun run, VirtualRunObservation sight) {
        return run.stage() == FLYING
                && run.note().equals(IN_THE_AIR)
                && Duration.between(run.changedAt(), sight.now()).compareTo(LONGEST_WAIT) > 0;
    }

    private static boolean mayOrder(VirtualRun run, VirtualRunObservation sight) {
        VirtualRunAssignment assignment = run.assignment();
        return assignment != null
                && (assignment.command() == null
                        || Duration.between(assignment.changedAt(), sight.now()).compareTo(BETWEEN_ORDERS) >= 0);
    }

    private static Command onward(VirtualRun run, DroneState drone) {
        return run.stage() == FLYING ? new Command.StartMission(run.onCloudLoss()) : VirtualRunMachine.homeward(drone);
    }
}
