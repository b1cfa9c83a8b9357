package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 285, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record GimbalDeviceAttitudeStatus(
        int targetSystem,
        int targetComponent,
        long timeBootMs,
        int flags,
        float[] q,
        float angularVelocityX,
        float angularVelocityY,
        float angularVelocityZ,
        long failureFlags,
        float deltaYaw,
        float deltaYawVelocity)
        implements Message {
    public static final int ID = 285;

    public static GimbalDeviceAttitudeStatus decode(Frame frame) {
        return new GimbalDeviceAttitudeStatus(
                frame.u8(38),
                frame.u8(39),
                frame.u32(0),
                frame.u16(36),
                frame.f32s(4, 4),
                frame.f32(20),
                frame.f32(24),
                frame.f32(28),
                frame.u32(32),
                frame.f32(40),
                frame.f32(44));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeBootMs);
        out.f32s(q, 4);
        out.f32(angularVelocityX);
        out.f32(angularVelocityY);
        out.f32(angularVelocityZ);
        out.u32(failureFlags);
        out.u16(flags);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.f32(deltaYaw);
        out.f32(deltaYawVelocity);
    }
}
