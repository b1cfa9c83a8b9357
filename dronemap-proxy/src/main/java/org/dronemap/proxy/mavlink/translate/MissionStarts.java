package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.CommandRequest;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.Observer;
import org.dronemap.proxy.mavlink.procedure.ParameterChange;
import org.dronemap.proxy.mavlink.procedure.Sequence;
import org.dronemap.proxy.mavlink.procedure.SetCurrentItem;

/** Makes the exchanges that start or resume the mission on an ArduPilot vehicle. */
final class MissionStarts {
    private MissionStarts() {}

    /** {@code auto}: the change to the mode that it flies missions in. */
    static Exchange begin(
            Cockpit cockpit, Command.StartMission start, VehicleKind kind, Function<Observer, Exchange> auto) {
        boolean fromGround = !cockpit.status().airborne();
        List<Sequence.Step> steps = new ArrayList<>(cloudLoss(cockpit, start.onCloudLoss(), kind));
        if (start.anew() && !fromGround) {
            // It would go on with the number of the item that it had, whatever is there now.
            steps.add(Sequence.Step.of(() ->
                    new SetCurrentItem(cockpit.target(), ArduPilot.HOME_ITEMS, seq -> seq == ArduPilot.HOME_ITEMS)));
        } else if (fromGround || cockpit.status().missionFinished()) {
            // Who does not say so begins at item 1 by itself; this one answer more is no reason to stay on the ground.
            steps.add(new Sequence.Step(() -> new SetCurrentItem(cockpit.target(), 0, seq -> seq <= 1), any -> true));
        }
        boolean copterOnGround = fromGround && (kind == VehicleKind.MULTICOPTER || kind == VehicleKind.HELICOPTER);
        steps.add(Sequence.Step.of(() -> auto.apply(copterOnGround ? Observer.NONE : cockpit.observer())));
        if (copterOnGround) {
            steps.add(Sequence.Step.of(() -> new CommandExchange(
                    cockpit.target(),
                    CommandRequest.ofLong(
                            cockpit.target(),
                            Maneuvers.MISSION_START,
                            new float[0],
                            CommandRequest.Retry.REPEATABLE,
                            CommandRequest.Proof.ACKNOWLEDGED),
                    cockpit.observer())));
        }
        return new Sequence(steps);
    }

    /**
     * Only what is said about missions: all else was set before it was armed, and what planes and rovers do they do without their
     * remote control as well.
     */
    private static List<Sequence.Step> cloudLoss(Cockpit cockpit, CloudLoss onCloudLoss, VehicleKind kind) {
        boolean goOn = onCloudLoss == CloudLoss.CONTINUE;
        return switch (kind) {
            case MULTICOPTER, HELICOPTER ->
                List.of(Maneuvers.wish(
                        cockpit, new ParameterChange.Wanted("FS_OPTIONS", old -> goOn ? old | 2 : old & ~2, false)));
            case FIXED_WING, VTOL, ROVER, BOAT -> {
                if (goOn) {
                    cockpit.warning()
                            .accept(
                                    "Whether this vehicle goes on with its mission when the cloud falls silent is as its"
                                            + " owner has set it: it cannot be told so without its remote control being meant, too.");
                }
                yield List.of();
            }
            case SUBMARINE, AIRSHIP, UNKNOWN -> List.of();
        };
    }
}
