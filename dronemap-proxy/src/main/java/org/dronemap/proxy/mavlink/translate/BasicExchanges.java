package org.dronemap.proxy.mavlink.translate;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.dronemap.proxy.mavlink.procedure.ParameterUpdateExchange;

/** Makes the exchanges (arm, change mode, take a picture) that the adapters of all autopilots share. */
final class BasicExchanges {
    static final int DO_SET_MODE = 176;
    static final int DO_REPOSITION = 192;
    static final int MISSION_START = 300;
    static final int ARM_DISARM = 400;
    private static final MavCommandRequest.Retry REPEATABLE = MavCommandRequest.Retry.REPEATABLE;
    private static final int DO_SET_RELAY = 181;
    private static final int DO_DIGICAM_CONTROL = 203;
    private static final int IMAGE_START_CAPTURE = 2000;
    private static final float FORCE = 21196f;
    private static final float CUSTOM_MODE = 1f;
    /** ArduPlane's word for a mission that has landed it. */
    private static final String STILL_LANDING = "In landing sequence";

    private static final String FLIES_AGAIN =
            "Its mission ended with a landing; change its mode to MANUAL first, and then"
                    + " to the one that it is to fly in.";
    private static final double CLIMBED_METERS = 1;
    private static final Duration TO_ARM = Duration.ofSeconds(5);
    private static final Duration TO_CHANGE_MODE = Duration.ofSeconds(5);
    private static final Duration TO_CLIMB = Duration.ofSeconds(25);

    private BasicExchanges() {}

    /** A command of which twice would be once too often. */
    static CommandExchange once(CommandContext cockpit, int command, float... parameters) {
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(),
                        command,
                        parameters,
                        MavCommandRequest.Retry.ONCE,
                        MavCommandRequest.CompletionCheck.ACKNOWLEDGED),
                cockpit.observer());
    }

    /** The newer command for cameras, and where it is not known the older one. */
    static Exchange picture(CommandContext cockpit) {
        CommandExchange capture =
                once(cockpit, IMAGE_START_CAPTURE, 0f, 0f, 1f, cockpit.status().nextPicture());
        return new FallbackExchange(
                capture,
                refused -> capture.isUnknownToVehicle(),
                () -> once(cockpit, DO_DIGICAM_CONTROL, 0f, 0f, 0f, 0f, 1f));
    }

    static Exchange relay(CommandContext cockpit, Command.SetRelay command) {
        float setting = switch (command.setting()) {
            case OFF -> 0f;
            case ON -> 1f;
            case TOGGLE -> 2f;
        };
        return once(cockpit, DO_SET_RELAY, command.relay(), setting);
    }

    static Exchange arm(CommandContext cockpit) {
        MavCommandRequest.CompletionCheck proof = new MavCommandRequest.CompletionCheck(
                cockpit.status()::armed,
                TO_ARM,
                "The vehicle said that it arms, but it is still disarmed after 5 s.",
                Heartbeat.ID);
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(cockpit.target(), ARM_DISARM, new float[] {1f}, REPEATABLE, proof),
                cockpit.observer());
    }

    /**
     * The same, with the way out where the vehicle refuses it for its mode. It is asked all the same: a setting of the vehicle
     * may allow it.
     */
    static Exchange arm(CommandContext cockpit, Capabilities can) {
        String mode = cockpit.status().mode();
        return new ExplainedExchange(arm(cockpit), said -> {
            Optional<String> wayOut = said.sentence().contains(STILL_LANDING)
                    ? Optional.of(FLIES_AGAIN)
                    : can.armingMode(mode)
                            .map(usual -> "It is not armed in " + mode + "; change its mode to " + usual + " first.");
            return wayOut.map(sentence -> ExplainedExchange.after(said, OutcomeCode.MODE_DOES_NOT_ARM, sentence));
        });
    }

    static Exchange disarm(CommandContext cockpit, boolean force) {
        MavCommandRequest.CompletionCheck proof = new MavCommandRequest.CompletionCheck(
                () -> !cockpit.status().armed(),
                TO_ARM,
                "The vehicle said that it disarms, but it is still armed after 5 s.",
                Heartbeat.ID);
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(), ARM_DISARM, new float[] {0f, force ? FORCE : 0f}, REPEATABLE, proof),
                cockpit.observer());
    }

    static Exchange mode(CommandContext cockpit, String name, float main, float sub, ExchangeObserver observer) {
        MavCommandRequest.CompletionCheck proof = new MavCommandRequest.CompletionCheck(
                () -> cockpit.status().inMode(name),
                TO_CHANGE_MODE,
                "The vehicle accepted mode " + name + ", but does not show it after 5 s.",
                Heartbeat.ID);
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(), DO_SET_MODE, new float[] {CUSTOM_MODE, main, sub}, REPEATABLE, proof),
                observer);
    }

    /** When it is seen to climb, whatever it answered. */
    static MavCommandRequest.CompletionCheck climbing(VehicleStatus status) {
        Double before = status.altitudeAboveHomeMeters();
        double start = before == null ? 0 : before;
        return new MavCommandRequest.CompletionCheck(
                () -> {
                    Double above = status.altitudeAboveHomeMeters();
                    FlightPhase phase = status.phase();
                    return phase == FlightPhase.TAKING_OFF
                            || phase == FlightPhase.IN_AIR
                            || (above != null && above - start >= CLIMBED_METERS);
                },
                TO_CLIMB,
                "The vehicle accepted the take-off, but did not climb within 25 s.",
                MavCommandRequest.CompletionCheck.ANY);
    }

    /** Sets a parameter if the vehicle has it; goes on with a warning if not. */
    static ExchangeSequence.Step setParameterStep(CommandContext cockpit, ParameterUpdateExchange.Wanted wanted) {
        Predicate<Outcome> goesOn = outcome -> {
            if (!(outcome instanceof Outcome.Succeeded)) {
                cockpit.warning()
                        .accept("What the vehicle does when the cloud falls silent could not be set (" + wanted.name()
                                + "); it follows its own setting.");
            }
            return true;
        };
        return new ExchangeSequence.Step(() -> new ParameterUpdateExchange(cockpit.target(), wanted), goesOn);
    }

    /** The gate lets nothing through that the autopilot does not declare; whatever comes all the same is not carried out. */
    static Exchange cannot(Command command) {
        return refuse(OutcomeCode.CAPABILITY_MISSING, "This autopilot has no way to " + command.summary() + ".");
    }

    static Exchange refuse(OutcomeCode code, String why) {
        return new ImmediateExchange(() -> new Outcome.Refused("gate", new Refusal(code, why)));
    }
}
