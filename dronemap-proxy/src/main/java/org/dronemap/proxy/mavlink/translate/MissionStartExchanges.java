package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.dronemap.proxy.mavlink.procedure.ParameterUpdateExchange;
import org.dronemap.proxy.mavlink.procedure.SetCurrentItemExchange;
import org.jspecify.annotations.Nullable;

/** Makes the exchanges that start or resume the mission on an ArduPilot vehicle. */
final class MissionStartExchanges {
    private MissionStartExchanges() {}

    /** {@code auto}: the change to the mode that it flies missions in. */
    static Exchange begin(
            CommandContext cockpit,
            Command.StartMission start,
            VehicleKind kind,
            Function<ExchangeObserver, Exchange> auto) {
        // What drives goes on from wherever it stands.
        boolean fromGround = !cockpit.status().airborne() && !kind.neverFlies();
        List<ExchangeSequence.Step> steps = new ArrayList<>(OwnFenceExchanges.warn(cockpit));
        steps.addAll(cloudLoss(cockpit, start.onCloudLoss(), kind));
        boolean resumes = cockpit.status().resumesMission(ArduPilotAdapter.HOME_ITEMS);
        boolean elsewhere = start.anew() || cockpit.status().currentSeq() > ArduPilotAdapter.HOME_ITEMS;
        if (!fromGround && elsewhere && (start.anew() || !resumes)) {
            // It would go on with the number of the item that it had, whatever is there now.
            steps.add(ExchangeSequence.Step.of(() -> new SetCurrentItemExchange(
                    cockpit.target(), ArduPilotAdapter.HOME_ITEMS, seq -> seq == ArduPilotAdapter.HOME_ITEMS)));
        } else if (!resumes) {
            // Who does not say so begins at item 1 by itself; this one answer more is no reason to stay on the ground.
            steps.add(new ExchangeSequence.Step(
                    () -> new SetCurrentItemExchange(cockpit.target(), 0, seq -> seq <= 1), any -> true));
        }
        boolean copterOnGround = fromGround && (kind == VehicleKind.MULTICOPTER || kind == VehicleKind.HELICOPTER);
        steps.add(ExchangeSequence.Step.of(
                () -> auto.apply(copterOnGround ? ExchangeObserver.NONE : cockpit.observer())));
        if (copterOnGround) {
            steps.add(ExchangeSequence.Step.of(() -> new CommandExchange(
                    cockpit.target(),
                    MavCommandRequest.ofLong(
                            cockpit.target(),
                            BasicExchanges.MISSION_START,
                            new float[0],
                            MavCommandRequest.Retry.REPEATABLE,
                            MavCommandRequest.CompletionCheck.ACKNOWLEDGED),
                    cockpit.observer())));
        }
        return new ExchangeSequence(steps);
    }

    /**
     * Only what is said about missions: all else was set before it was armed, and what planes and rovers do they do without their
     * remote control as well.
     */
    private static List<ExchangeSequence.Step> cloudLoss(
            CommandContext cockpit, @Nullable MissionCloudLossPolicy onCloudLoss, VehicleKind kind) {
        if (onCloudLoss == null) {
            return List.of();
        }
        boolean goOn = onCloudLoss == MissionCloudLossPolicy.CONTINUE;
        return switch (kind) {
            case MULTICOPTER, HELICOPTER ->
                List.of(BasicExchanges.setParameterStep(
                        cockpit,
                        new ParameterUpdateExchange.Wanted("FS_OPTIONS", old -> goOn ? old | 2 : old & ~2, false)));
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
