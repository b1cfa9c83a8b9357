package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 84, raw fields as on the wire. Generated: see MessageGenerator. */
public record SetPositionTargetLocalNed(
        long timeBootMs,
        int targetSystem,
        int targetComponent,
        int coordinateFrame,
        int typeMask,
        float x,
        float y,
        float z,
        float vx,
        float vy,
        float vz,
        float afx,
        float afy,
        float afz,
        float yaw,
        float yawRate)
        implements Message {
    public static final int ID = 84;

    public static SetPositionTargetLocalNed decode(Frame frame) {
        return new SetPositionTargetLocalNed(
                frame.u32(0),
                frame.u8(50),
                frame.u8(51),
                frame.u8(52),
                frame.u16(48),
                frame.f32(4),
                frame.f32(8),
                frame.f32(12),
                frame.f32(16),
                frame.f32(20),
                frame.f32(24),
                frame.f32(28),
                frame.f32(32),
                frame.f32(36),
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
        out.f32(x);
        out.f32(y);
        out.f32(z);
        out.f32(vx);
        out.f32(vy);
        out.f32(vz);
        out.f32(afx);
        out.f32(afy);
        out.f32(afz);
        out.f32(yaw);
        out.f32(yawRate);
        out.u16(typeMask);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(coordinateFrame);
    }
}
