package org.dronemap.proxy.mavlink.procedure;

import java.util.Set;
import java.util.function.BiConsumer;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.command.Setpoint;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;

/**
 * Points the camera gimbal of a steered MAVLink vehicle where setpoints look, and releases it when they end. Says
 * nothing to vehicles without one, and nothing once somebody else has control: where the camera looks is theirs then.
 * Owned by the drone's lane.
 */
public final class GimbalControl {
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long PAUSE_NANOS = SECOND_NANOS / 2;
    private static final long PATIENCE_NANOS = 3 * SECOND_NANOS;
    /** Each may be lost. */
    private static final int FAREWELLS = 3;

    /** MOUNT_STATUS, MOUNT_ORIENTATION, GIMBAL_MANAGER_INFORMATION, GIMBAL_MANAGER_STATUS, GIMBAL_DEVICE_ATTITUDE_STATUS. */
    private static final Set<Integer> REPORTS = Set.of(158, 265, 280, 281, 285);

    /** Back to the middle, as when nobody points it. */
    private static final int NEUTRAL = 2;
    /** Level with the horizon, whatever the vehicle does; sideways it looks where the vehicle does. */
    private static final int LEVEL = 4 | 8;

    private final MavlinkTarget target;
    private final BiConsumer<Message, SendAuthority> out;
    private boolean there;
    private boolean points;
    private int farewells;
    /** Of whoever pointed it last. */
    private SendAuthority mandate = SendAuthority.HOUSEKEEPING;

    private long pointedNanos;
    private long wantedNanos;

    /** {@code out}: sends what the mandate still lets pass. */
    public GimbalControl(MavlinkTarget target, BiConsumer<Message, SendAuthority> out) {
        this.target = target;
        this.out = out;
    }

    /** Any component of the vehicle said something. */
    public void received(Frame frame) {
        there |= REPORTS.contains(frame.messageId());
    }

    /** The vehicle is steered like this. */
    public void steered(SendAuthority by, Setpoint setpoint, long now) {
        Double degrees = setpoint instanceof Setpoint.Track track ? track.cameraElevationDegrees() : null;
        if (!there || degrees == null) {
            return;
        }
        mandate = by;
        wantedNanos = now;
        if (points && now - pointedNanos < PAUSE_NANOS) {
            return;
        }
        points = true;
        farewells = FAREWELLS;
        pointedNanos = now;
        sendPitch(LEVEL, (float) Math.toRadians(degrees));
    }

    /** Nobody says any more where it shall look: it is let go. */
    public void advance(long now) {
        if (now - wantedNanos < PATIENCE_NANOS || farewells == 0 || now - pointedNanos < PAUSE_NANOS) {
            return;
        }
        points = false;
        farewells--;
        pointedNanos = now;
        sendPitch(NEUTRAL, Float.NaN);
    }

    private void sendPitch(int flags, float pitch) {
        float yaw = Float.isNaN(pitch) ? Float.NaN : 0f;
        out.accept(
                new GimbalManagerSetPitchyaw(
                        target.systemId(), target.componentId(), flags, 0, pitch, yaw, Float.NaN, Float.NaN),
                mandate);
    }
}
