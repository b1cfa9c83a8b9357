package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 287, raw fields as on the wire. Generated: see MessageGenerator. */
public record GimbalManagerSetPitchyaw(
        int targetSystem,
        int targetComponent,
        long flags,
        int gimbalDeviceId,
        float pitch,
        float yaw,
        float pitchRate,
        float yawRate)
        implements Message {
    public static final int ID = 287;

    public static GimbalManagerSetPitchyaw decode(Frame frame) {
        return new GimbalManagerSetPitchyaw(
                frame.u8(20),
                frame.u8(21),
                frame.u32(0),
                frame.u8(22),
                frame.f32(4),
                frame.f32(8),
                frame.f32(12),
                frame.f32(16));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(flags);
        out.f32(pitch);
        out.f32(yaw);
        out.f32(pitchRate);
        out.f32(yawRate);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(gimbalDeviceId);
    }
}
