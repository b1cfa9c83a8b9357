package org.dronemap.proxy.outlet.uplink;

import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.jspecify.annotations.Nullable;

/** Reads stick input and position targets of ground stations at the outlet as setpoints. Stateless. */
final class ClientSteeringReader {
    private static final int POSITION = 0x007;
    private static final int SPEED = 0x038;
    private static final int ACCELERATION = 0x1C0;
    private static final int FORCE = 0x200;
    private static final int YAW = 0x400;
    private static final int YAW_RATE = 0x800;

    private static final double E7 = 1e7;
    private static final double STICK_END = 1000;
    private static final double STICK_HALF = 500;
    private static final int STICK_UNSAID = Short.MAX_VALUE;
    private static final int PULSE_MIDDLE = 1500;
    private static final double PULSE_HALF = 500;
    private static final int PULSE_UNSAID = 0xFFFF;
    private static final int PULSE_SHORTEST = 800;
    private static final int PULSE_LONGEST = 2200;

    private static final String ONLY_FOUR =
            "Only the channels 1 to 4 pass the cloud; the others do nothing: modes and switches are commands.";

    private ClientSteeringReader() {}

    /** The intent of a client's steering message. */
    sealed interface Intent {
        /** The remark says what else was said, and is left out. */
        record Steer(Setpoint setpoint, Optional<String> remark) implements Intent {
            Steer(Setpoint setpoint) {
                this(setpoint, Optional.empty());
            }
        }

        /** To be at a place, said alone: as a command when it is said once. */
        record Place(Setpoint.Track track) implements Intent {}

        record LetGo() implements Intent {}

        record Nothing() implements Intent {}

        record Denied(String sentence) implements Intent {}
    }

    static Intent of(Frame frame, VehicleKind kind) {
        try {
            return switch (frame.messageId()) {
                case ManualControl.ID -> sticks(ManualControl.decode(frame), kind);
                case RcChannelsOverride.ID -> channels(RcChannelsOverride.decode(frame), kind);
                case SetPositionTargetLocalNed.ID -> speeds(SetPositionTargetLocalNed.decode(frame));
                default -> place(SetPositionTargetGlobalInt.decode(frame));
            };
        } catch (IllegalArgumentException outOfRange) {
            return new Intent.Denied("This cannot be steered by: " + outOfRange.getMessage() + ".");
        }
    }

    /** Of the system that it is for; 0: of all. */
    static int component(Frame frame) {
        return switch (frame.messageId()) {
            case RcChannelsOverride.ID -> RcChannelsOverride.decode(frame).targetComponent();
            case SetPositionTargetLocalNed.ID ->
                SetPositionTargetLocalNed.decode(frame).targetComponent();
            case SetPositionTargetGlobalInt.ID ->
                SetPositionTargetGlobalInt.decode(frame).targetComponent();
            default -> 0;
        };
    }

    private static Intent sticks(ManualControl said, VehicleKind kind) {
        boolean pressed = said.buttons() != 0 || said.buttons2() != 0;
        Setpoint sticks = drives(kind)
                ? new Setpoint.Sticks(stick(said.z()), 0, 0, stick(said.y()))
                : new Setpoint.Sticks(
                        stick(said.x()),
                        stick(said.y()),
                        said.z() == STICK_UNSAID ? 0 : (said.z() - STICK_HALF) / STICK_HALF,
                        stick(said.r()));
        return new Intent.Steer(
                sticks,
                pressed
                        ? Optional.of("Buttons of joysticks do nothing through the cloud; only sticks do.")
                        : Optional.empty());
    }

    private static double stick(int value) {
        return value == STICK_UNSAID ? 0 : value / STICK_END;
    }

    /** The first four channels as radios come: roll, pitch (backwards is more), throttle, yaw. */
    private static Intent channels(RcChannelsOverride said, VehicleKind kind) {
        int[] sticks = {said.chan1Raw(), said.chan2Raw(), said.chan3Raw(), said.chan4Raw()};
        int released = 0;
        int unsaid = 0;
        for (int pulse : sticks) {
            released += pulse == 0 ? 1 : 0;
            unsaid += pulse == PULSE_UNSAID ? 1 : 0;
            if (pulse != 0 && pulse != PULSE_UNSAID && (pulse < PULSE_SHORTEST || pulse > PULSE_LONGEST)) {
                return new Intent.Denied(
                        "A channel is " + PULSE_SHORTEST + " to " + PULSE_LONGEST + " us, not " + pulse + ".");
            }
        }
        if (released + unsaid == sticks.length) {
            return released > 0 ? new Intent.LetGo() : new Intent.Nothing();
        }
        double first = share(sticks[0]);
        double third = share(sticks[2]);
        return new Intent.Steer(
                drives(kind)
                        ? new Setpoint.Sticks(third, 0, 0, first)
                        : new Setpoint.Sticks(0.0 - share(sticks[1]), first, third, share(sticks[3])),
                isSwitched(said) ? Optional.of(ONLY_FOUR) : Optional.empty());
    }

    private static boolean isSwitched(RcChannelsOverride said) {
        IntPredicate isUnsaid = pulse -> pulse == 0 || pulse == PULSE_UNSAID;
        boolean firstEight = IntStream.of(said.chan5Raw(), said.chan6Raw(), said.chan7Raw(), said.chan8Raw())
                .allMatch(isUnsaid);
        boolean others = IntStream.of(
                        said.chan9Raw(),
                        said.chan10Raw(),
                        said.chan11Raw(),
                        said.chan12Raw(),
                        said.chan13Raw(),
                        said.chan14Raw(),
                        said.chan15Raw(),
                        said.chan16Raw(),
                        said.chan17Raw(),
                        said.chan18Raw())
                .allMatch(isUnsaid);
        return !(firstEight && others);
    }

    private static double share(int pulse) {
        if (pulse == 0 || pulse == PULSE_UNSAID) {
            return 0;
        }
        return Math.max(-1, Math.min(1, (pulse - PULSE_MIDDLE) / PULSE_HALF));
    }

    private static boolean drives(VehicleKind kind) {
        return kind == VehicleKind.ROVER || kind == VehicleKind.BOAT;
    }

    private static Intent speeds(SetPositionTargetLocalNed said) {
        Setpoint.Frame frame = speedFrame(said.coordinateFrame());
        boolean onlySpeeds = (said.typeMask() & POSITION) == POSITION && (said.typeMask() & SPEED) == 0;
        if (frame == null || !onlySpeeds || accelerates(said.typeMask())) {
            return new Intent.Denied(
                    frame == null
                            ? "Speeds are counted in frame 1, 7, 8, 9 or 12, not in " + said.coordinateFrame() + "."
                            : "Of local targets only speeds pass the cloud, alone (type_mask 0xDC7, 0x9C7 or 0x5C7);"
                                    + " places are SET_POSITION_TARGET_GLOBAL_INT.");
        }
        return new Intent.Steer(new Setpoint.Velocity(
                frame, said.vx(), said.vy(), said.vz(), facing(said.typeMask(), said.yaw(), said.yawRate())));
    }

    private static Setpoint.@Nullable Frame speedFrame(int frame) {
        return switch (frame) {
            case 1, 7 -> Setpoint.Frame.EARTH;
            case 8, 9, 12 -> Setpoint.Frame.VEHICLE;
            default -> null;
        };
    }

    private static Intent place(SetPositionTargetGlobalInt said) {
        int unsaid = said.typeMask() & POSITION;
        boolean moves = (said.typeMask() & SPEED) == 0;
        boolean whole = unsaid == 0 || (unsaid == POSITION && moves);
        if (!whole || accelerates(said.typeMask())) {
            return new Intent.Denied("Of global targets whole places and speeds pass the cloud, accelerations do not.");
        }
        Altitude altitude = ClientCommandReader.altitude(said.coordinateFrame(), unsaid == 0 ? said.alt() : 0);
        if (altitude == null) {
            return new Intent.Denied("A global target needs a frame counted from home or from the sea, and a height.");
        }
        Facing facing = facing(said.typeMask(), said.yaw(), said.yawRate());
        Setpoint.Velocity moving =
                moves ? new Setpoint.Velocity(Setpoint.Frame.EARTH, said.vx(), said.vy(), said.vz(), facing) : null;
        return unsaid == 0 || moving == null ? place(said, altitude, moving, facing) : new Intent.Steer(moving);
    }

    private static Intent place(
            SetPositionTargetGlobalInt said, Altitude altitude, Setpoint.@Nullable Velocity moving, Facing facing) {
        Setpoint.Track track =
                new Setpoint.Track(new Geodetic(said.latInt() / E7, said.lonInt() / E7), altitude, moving, facing);
        return moving == null && facing instanceof Facing.Any ? new Intent.Place(track) : new Intent.Steer(track);
    }

    private static boolean accelerates(int mask) {
        return (mask & ACCELERATION) != ACCELERATION || (mask & FORCE) != 0;
    }

    private static Facing facing(int mask, float yaw, float yawRate) {
        if ((mask & YAW) == 0) {
            return new Facing.Heading(Math.toDegrees(yaw));
        }
        return (mask & YAW_RATE) == 0 ? new Facing.Turning(Math.toDegrees(yawRate)) : Facing.ANY;
    }
}
