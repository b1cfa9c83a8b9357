package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;

/**
 * Encodes the cloud's setpoints as MAVLink messages to a vehicle: position targets and MANUAL_CONTROL. Speeds and
 * places are position targets whose mask says what counts (<a
 * href="https://mavlink.io/en/messages/common.html#POSITION_TARGET_TYPEMASK">POSITION_TARGET_TYPEMASK</a>), sticks are
 * MANUAL_CONTROL, whose middle of the throttle is 500; ground vehicles take their throttle from z and their steering
 * from y. Immutable.
 */
final class SetpointEncoder {
    private static final int FRAME_LOCAL_NED = 1;
    private static final int FRAME_BODY_NED = 8;
    private static final int FRAME_GLOBAL = 5;
    private static final int FRAME_RELATIVE = 6;

    private static final int NO_POSITION = 0x007;
    private static final int NO_SPEED = 0x038;
    private static final int NO_ACCELERATION = 0x1C0;
    private static final int NO_YAW = 0x400;
    private static final int NO_YAW_RATE = 0x800;

    private static final double FULL = 1000;
    private static final double HALF = 500;

    private final MavlinkTarget target;
    private final boolean drives;

    SetpointEncoder(MavlinkTarget target, VehicleKind kind) {
        this.target = target;
        drives = kind == VehicleKind.ROVER || kind == VehicleKind.BOAT;
    }

    Optional<Message> encode(Setpoint setpoint) {
        return Optional.of(
                switch (setpoint.kind()) {
                    case VELOCITY -> speeds((Setpoint.Velocity) setpoint);
                    case TRACK -> place((Setpoint.Track) setpoint);
                    case STICKS -> sticks((Setpoint.Sticks) setpoint);
                });
    }

    private SetPositionTargetLocalNed speeds(Setpoint.Velocity velocity) {
        return new SetPositionTargetLocalNed(
                0,
                target.systemId(),
                target.componentId(),
                velocity.frame() == Setpoint.Frame.VEHICLE ? FRAME_BODY_NED : FRAME_LOCAL_NED,
                NO_POSITION | NO_ACCELERATION | mask(velocity.facing()),
                0f,
                0f,
                0f,
                (float) velocity.forward(),
                (float) velocity.right(),
                (float) velocity.down(),
                0f,
                0f,
                0f,
                yaw(velocity.facing()),
                yawRate(velocity.facing()));
    }

    private SetPositionTargetGlobalInt place(Setpoint.Track track) {
        Setpoint.Velocity moving = track.moving();
        return new SetPositionTargetGlobalInt(
                0,
                target.systemId(),
                target.componentId(),
                track.altitude().reference() == Altitude.Reference.HOME ? FRAME_RELATIVE : FRAME_GLOBAL,
                (moving == null ? NO_SPEED : 0) | NO_ACCELERATION | mask(track.facing()),
                MissionCodec.e7(track.point().latitudeDegrees()),
                MissionCodec.e7(track.point().longitudeDegrees()),
                (float) track.altitude().meters(),
                moving == null ? 0f : (float) moving.forward(),
                moving == null ? 0f : (float) moving.right(),
                moving == null ? 0f : (float) moving.down(),
                0f,
                0f,
                0f,
                yaw(track.facing()),
                yawRate(track.facing()));
    }

    private ManualControl sticks(Setpoint.Sticks sticks) {
        return drives
                ? manual(0, full(sticks.turn()), full(sticks.forward()), 0)
                : manual(
                        full(sticks.forward()),
                        full(sticks.right()),
                        (int) Math.round(HALF + HALF * sticks.up()),
                        full(sticks.turn()));
    }

    private ManualControl manual(int x, int y, int z, int r) {
        return new ManualControl(target.systemId(), x, y, z, r, 0, 0, 0, 0, 0);
    }

    private static int full(double share) {
        return (int) Math.round(FULL * share);
    }

    private static int mask(Setpoint.Facing facing) {
        if (facing instanceof Setpoint.Facing.Heading) {
            return NO_YAW_RATE;
        }
        return facing instanceof Setpoint.Facing.Turning ? NO_YAW : NO_YAW | NO_YAW_RATE;
    }

    private static float yaw(Setpoint.Facing facing) {
        return facing instanceof Setpoint.Facing.Heading heading ? (float) Math.toRadians(heading.degrees()) : 0f;
    }

    private static float yawRate(Setpoint.Facing facing) {
        return facing instanceof Setpoint.Facing.Turning turning
                ? (float) Math.toRadians(turning.degreesPerSecond())
                : 0f;
    }
}
