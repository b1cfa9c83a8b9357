package org.dronemap.core.cloud.rule;

import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Rules by which the state of a drone allows or forbids a command; used to check commands and to offer buttons. */
public final class CommandRules {
    private static final Refusal ALREADY_ARMED = new Refusal(OutcomeCode.ALREADY_ARMED, "It is already armed.");
    private static final Refusal NOT_ARMED = new Refusal(OutcomeCode.NOT_ARMED, "It is not armed.");
    private static final Refusal ARM_FIRST = new Refusal(OutcomeCode.NOT_ARMED, "Arm first.");
    private static final Refusal LAND_FIRST = new Refusal(OutcomeCode.DRONE_AIRBORNE, "It is in the air; land first.");
    private static final Refusal IN_THE_AIR = new Refusal(OutcomeCode.DRONE_AIRBORNE, "It is already in the air.");
    private static final Refusal TAKE_OFF_FIRST = new Refusal(OutcomeCode.NOT_AIRBORNE, "Take off first.");
    private static final Refusal UPLOAD_FIRST = new Refusal(OutcomeCode.MISSION_MISSING, "Upload a mission first.");

    private static final int MODES_NAMED = 2;
    /** In one command. */
    private static final double FARTHEST_METERS = 100_000;

    private CommandRules() {}

    /** Why a command of this kind cannot be given now; empty when it can. */
    public static Optional<Refusal> whyNot(DroneState drone, Capability capability) {
        if (drone.replay()) {
            return because(OutcomeCode.DRONE_IS_A_RECORDING, "This is a recording; it cannot be commanded.");
        }
        if (drone.link().state() == LinkState.LOST) {
            return because(
                    OutcomeCode.CONTACT_LOST, "There is no contact with the drone; a command would not reach it.");
        }
        if (!drone.capabilities().known()) {
            return because(
                    OutcomeCode.CAPABILITIES_UNKNOWN,
                    "It is not known yet what this vehicle can do; try again in a moment.");
        }
        if (!drone.capabilities().commands().contains(capability)) {
            return because(
                    OutcomeCode.CAPABILITY_MISSING,
                    "This vehicle (" + drone.identification().vehicle() + ") cannot " + capability.phrase() + "."
                            + insteadOf(drone, capability));
        }
        return Optional.ofNullable(stateForbids(drone, capability));
    }

    /** The way out for what flies on wings: missions do for it what commands do for copters. */
    private static String insteadOf(DroneState drone, Capability capability) {
        boolean byMission = drone.identification().kind() == VehicleKind.FIXED_WING
                && drone.capabilities().commands().contains(Capability.START_MISSION);
        if (byMission && capability == Capability.TAKE_OFF) {
            return " It takes off by a mission: upload one that begins with takeOff, arm, and start the mission.";
        }
        if (byMission && capability == Capability.LAND) {
            return " It lands by a mission: upload one that ends with land, and start it; return to launch lands where"
                    + " its mission has a landing sequence, and circles above home otherwise.";
        }
        return "";
    }

    /** The same, looking into the command as well. */
    public static Optional<Refusal> whyNot(DroneState drone, Command command) {
        if (isStopInTheAir(drone, command)) {
            // Deliberate: the one way to stop motors in the air.
            return whyNot(drone, Capability.ARM).filter(why -> !why.equals(ALREADY_ARMED));
        }
        return whyNot(drone, command.needs()).or(() -> contentForbids(drone, command));
    }

    private static boolean isStopInTheAir(DroneState drone, Command command) {
        return command instanceof Command.Disarm disarm && disarm.force() && drone.airborne();
    }

    private static Optional<Refusal> contentForbids(DroneState drone, Command command) {
        return switch (command.kind().movement()) {
            case CHANGES_MODE -> modeForbids(drone, ((Command.SetMode) command).mode());
            case GOES -> tooFar(drone, ((Command.GoTo) command).point());
            case TAKES_MISSION -> MissionRules.whyNot(drone, ((Command.UploadMission) command).mission());
            case CHANGES_SPEED -> SpeedRules.whyNot(drone, (ChangeSpeed) command);
            case NONE, STANDS, TURNS, CLIMBS, GOES_ON_ITS_MAP, FLIES_MISSION, COMES_DOWN -> Optional.empty();
        };
    }

    /** Why it cannot be steered so now; empty when it can. */
    public static Optional<Refusal> whyNot(DroneState drone, Setpoint setpoint) {
        return whyNot(drone, setpoint.needs())
                .or(() -> contentForbids(drone, setpoint))
                .or(() -> modeForbids(drone, setpoint.kind().steering()));
    }

    private static Optional<Refusal> contentForbids(DroneState drone, Setpoint setpoint) {
        return switch (setpoint.kind()) {
            case VELOCITY ->
                turnsUnknown(drone, (Setpoint.Velocity) setpoint)
                        ? because(
                                OutcomeCode.HEADING_UNKNOWN,
                                "Where it looks is not known; steer it by its own forward and right.")
                        : Optional.empty();
            case TRACK -> tooFar(drone, ((Setpoint.Track) setpoint).point());
            case STICKS -> Optional.empty();
        };
    }

    /** Where no mode says what the vehicle goes by, it is steered in any. */
    private static Optional<Refusal> modeForbids(DroneState drone, Steering wanted) {
        Capabilities can = drone.capabilities();
        if (!can.steering().containsValue(wanted) || can.steering(drone.mode()).equals(Optional.of(wanted))) {
            return Optional.empty();
        }
        Optional<String> usual = can.mode(wanted);
        return because(
                OutcomeCode.MODE_NOT_STEERABLE,
                "In " + drone.mode() + " it is not to be steered so; change its mode to "
                        + can.modes().stream()
                                .filter(mode -> can.steering().get(mode) == wanted)
                                .sorted(Comparator.comparing(mode -> !usual.equals(Optional.of(mode))))
                                .limit(MODES_NAMED)
                                .collect(Collectors.joining(" or "))
                        + " first.");
    }

    /** A place beyond all that drones fly at one go is a slip: of a digit, of a sign, or of a program that sends zeros. */
    private static Optional<Refusal> tooFar(DroneState drone, Geodetic point) {
        Geodetic here = drone.position() == null ? null : drone.position().point();
        if (here == null) {
            return Optional.empty();
        }
        double meters = Geodesy.distanceMeters(here, point);
        return meters <= FARTHEST_METERS
                ? Optional.empty()
                : because(
                        OutcomeCode.PLACE_TOO_FAR,
                        String.format(
                                Locale.ROOT,
                                "%s is %.0f km from where it is; it is sent at most %.0f km far.",
                                point.words(),
                                meters / 1_000,
                                FARTHEST_METERS / 1_000));
    }

    private static boolean turnsUnknown(DroneState drone, Setpoint.Velocity velocity) {
        Motion motion = drone.motion();
        boolean counted =
                velocity.frame() == Setpoint.Frame.EARTH || velocity.facing() instanceof Setpoint.Facing.Heading;
        return counted && (motion == null || motion.headingDegrees() == null) && !velocity.isStill();
    }

    private static @Nullable Refusal stateForbids(DroneState drone, Capability capability) {
        // What has no motors to arm is always ready.
        boolean arms = drone.capabilities().commands().contains(Capability.ARM);
        boolean armed = !arms || Boolean.TRUE.equals(drone.armed());
        return switch (capability.readiness()) {
            case ANY -> null;
            case DISARMED -> armed ? ALREADY_ARMED : null;
            case ARMED_ON_THE_GROUND -> armed ? (drone.airborne() ? LAND_FIRST : null) : NOT_ARMED;
            case READY_TO_TAKE_OFF -> armed ? (drone.airborne() ? IN_THE_AIR : null) : ARM_FIRST;
            case ARMED -> armed ? null : NOT_ARMED;
            case ARMED_BEFORE -> armed ? null : ARM_FIRST;
            case UNDER_WAY -> armed ? (needsAir(drone) && !drone.airborne() ? TAKE_OFF_FIRST : null) : ARM_FIRST;
            case WITH_MISSION -> hasMission(drone.mission()) ? (armed ? null : ARM_FIRST) : UPLOAD_FIRST;
        };
    }

    /** There is something to stop, and it knows how to. */
    public static boolean canHold(DroneState drone) {
        return whyNot(drone, Capability.HOLD).isEmpty() && (drone.airborne() || !needsAir(drone));
    }

    /** Robots of a kind that nobody knows drive, where they cannot take off. */
    public static boolean needsAir(DroneState drone) {
        VehicleKind kind = drone.identification().kind();
        boolean flies =
                kind != VehicleKind.UNKNOWN || drone.capabilities().commands().contains(Capability.TAKE_OFF);
        return flies && !kind.neverFlies();
    }

    private static boolean hasMission(MissionProgress mission) {
        return mission.items() != null && !mission.items().isEmpty();
    }

    private static Optional<Refusal> modeForbids(DroneState drone, String mode) {
        if (drone.capabilities().modes().contains(mode)) {
            return Optional.empty();
        }
        return because(
                OutcomeCode.MODE_UNKNOWN,
                "This vehicle has no mode " + mode + "; it knows "
                        + String.join(", ", drone.capabilities().modes()) + ".");
    }

    private static Optional<Refusal> because(OutcomeCode code, String sentence) {
        return Optional.of(new Refusal(code, sentence));
    }
}
