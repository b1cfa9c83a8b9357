package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Locale;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.jspecify.annotations.Nullable;

/** Makes the exchanges that change the speed of a vehicle, by DO_CHANGE_SPEED. */
final class SpeedExchanges {
    private static final int DO_CHANGE_SPEED = 178;
    private static final float THROUGH_THE_AIR = 0f;
    private static final float OVER_THE_GROUND = 1f;
    private static final float SAME_THROTTLE = -1f;

    private SpeedExchanges() {}

    /** Remembered for the mode that it is in: a go-to of a vehicle that forgets it with each new place says it again. */
    static Exchange change(CommandContext cockpit, ChangeSpeed command, VehicleKind kind) {
        double speed = command.metersPerSecond();
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> speedCommand(cockpit, speed, kind, cockpit.observer())),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    cockpit.status().speedChanged(speed);
                    return new Outcome.Succeeded();
                }))));
    }

    static Exchange ofArduPilot(CommandContext cockpit, ChangeSpeed command, VehicleKind kind) {
        return switch (kind) {
            case FIXED_WING, VTOL -> changePlane(cockpit, command, kind);
            case MULTICOPTER, HELICOPTER, ROVER, BOAT, SUBMARINE, AIRSHIP, UNKNOWN -> change(cockpit, command, kind);
        };
    }

    /** An ArduPilot plane changes its air speed in two modes, within bounds of its own. */
    private static Exchange changePlane(CommandContext cockpit, ChangeSpeed command, VehicleKind kind) {
        if (!cockpit.status().inMode("GUIDED") && !cockpit.status().inMode("AUTO")) {
            return BasicExchanges.refuse(
                    OutcomeCode.MODE_NOT_STEERABLE,
                    "A plane goes by such a speed in GUIDED and AUTO only; change its mode first.");
        }
        Double least = value(cockpit, "AIRSPEED_MIN", "ARSPD_FBW_MIN");
        Double most = value(cockpit, "AIRSPEED_MAX", "ARSPD_FBW_MAX");
        double speed = command.metersPerSecond();
        if (least != null && most != null && (speed < least || speed > most)) {
            return BasicExchanges.refuse(
                    OutcomeCode.SPEED_NOT_POSSIBLE,
                    String.format(
                            Locale.ROOT,
                            "metersPerSecond must be %.1f to %.1f for this plane (its AIRSPEED_MIN and AIRSPEED_MAX),"
                                    + " not %.1f.",
                            least,
                            most,
                            speed));
        }
        return new ExplainedExchange(
                change(cockpit, command, kind),
                "A plane takes only speeds from its parameter AIRSPEED_MIN to AIRSPEED_MAX; read its parameters.");
    }

    /** After a go-to: it keeps the speed that it was told since it is in this mode; a warning where it does not. */
    static ExchangeSequence.Step again(CommandContext cockpit, VehicleKind kind) {
        return new ExchangeSequence.Step(
                () -> {
                    Double speed = cockpit.status().speed();
                    return speed == null
                            ? new ImmediateExchange(Outcome.Succeeded::new)
                            : speedCommand(cockpit, speed, kind, ExchangeObserver.NONE);
                },
                outcome -> {
                    if (!(outcome instanceof Outcome.Succeeded)) {
                        cockpit.warning()
                                .accept("It goes there, perhaps not at the speed that it was told before: "
                                        + outcome.reason());
                    }
                    return true;
                });
    }

    private static Exchange speedCommand(
            CommandContext cockpit, double speed, VehicleKind kind, ExchangeObserver observer) {
        boolean wings = kind == VehicleKind.FIXED_WING || kind == VehicleKind.VTOL;
        float[] parameters = {wings ? THROUGH_THE_AIR : OVER_THE_GROUND, (float) speed, SAME_THROTTLE};
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(),
                        DO_CHANGE_SPEED,
                        parameters,
                        MavCommandRequest.Retry.REPEATABLE,
                        MavCommandRequest.CompletionCheck.ACKNOWLEDGED),
                observer);
    }

    private static @Nullable Double value(CommandContext cockpit, String name, String before) {
        Parameter parameter = cockpit.parameters().find(name);
        Parameter old = parameter == null ? cockpit.parameters().find(before) : parameter;
        return old == null ? null : old.value();
    }
}
