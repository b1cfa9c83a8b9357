package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.dronemap.proxy.mavlink.procedure.PositionTargetExchange;

/** Makes the exchanges by which an ArduPilot vehicle is led in GUIDED, which {@code guided} puts it into. */
final class GuidedExchanges {
    private static final int NAV_TAKEOFF = 22;
    private static final int CONDITION_YAW = 115;
    private static final float RELATIVE = 1f;
    private static final int FRAME_RELATIVE = 6;
    private static final int FRAME_GLOBAL = 5;

    private GuidedExchanges() {}

    static Exchange takeOff(CommandContext cockpit, ExchangeSequence.Step guided, Command.TakeOff command) {
        float[] parameters = {0f, 0f, 0f, 0f, 0f, 0f, (float) command.altitudeMeters()};
        return new ExchangeSequence(List.of(
                guided,
                ExchangeSequence.Step.of(() -> new CommandExchange(
                        cockpit.target(),
                        MavCommandRequest.ofLong(
                                cockpit.target(),
                                NAV_TAKEOFF,
                                parameters,
                                MavCommandRequest.Retry.VERIFY_FIRST,
                                BasicExchanges.climbing(cockpit.status())),
                        cockpit.observer()))));
    }

    static Exchange turn(CommandContext cockpit, ExchangeSequence.Step guided, double degrees) {
        float direction = degrees < 0 ? -1f : 1f;
        return new ExchangeSequence(List.of(
                guided,
                ExchangeSequence.Step.of(() -> BasicExchanges.once(
                        cockpit, CONDITION_YAW, (float) Math.abs(degrees), 0f, direction, RELATIVE))));
    }

    static Exchange goTo(CommandContext cockpit, ExchangeSequence.Step guided, Command.GoTo command, VehicleKind kind) {
        boolean relative = command.altitude().reference() == Altitude.Reference.HOME;
        CommandInt message = new CommandInt(
                cockpit.target().systemId(),
                cockpit.target().componentId(),
                relative ? FRAME_RELATIVE : FRAME_GLOBAL,
                BasicExchanges.DO_REPOSITION,
                0,
                0,
                -1f,
                1f,
                0f,
                Float.NaN,
                MissionCodec.e7(command.point().latitudeDegrees()),
                MissionCodec.e7(command.point().longitudeDegrees()),
                (float) command.altitude().meters());
        CommandExchange reposition = new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofInt(message, MavCommandRequest.Retry.REPEATABLE),
                cockpit.observer());
        return new ExchangeSequence(List.of(
                guided,
                ExchangeSequence.Step.of(() -> OwnFenceExchanges.goTo(
                        cockpit,
                        command,
                        new FallbackExchange(
                                reposition,
                                refused -> reposition.isUnknownToVehicle(),
                                () -> new PositionTargetExchange(cockpit.target(), message)))),
                SpeedExchanges.again(cockpit, kind)));
    }
}
