package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 180, raw fields as on the wire. Generated: see MessageGenerator. */
public record CameraFeedback(
        long timeUsec,
        int targetSystem,
        int camIdx,
        int imgIdx,
        int lat,
        int lng,
        float altMsl,
        float altRel,
        float roll,
        float pitch,
        float yaw,
        float focLen,
        int flags,
        int completedCaptures)
        implements Message {
    public static final int ID = 180;

    public static CameraFeedback decode(Frame frame) {
        return new CameraFeedback(
                frame.i64(0),
                frame.u8(42),
                frame.u8(43),
                frame.u16(40),
                frame.i32(8),
                frame.i32(12),
                frame.f32(16),
                frame.f32(20),
                frame.f32(24),
                frame.f32(28),
                frame.f32(32),
                frame.f32(36),
                frame.u8(44),
                frame.u16(45));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUsec);
        out.i32(lat);
        out.i32(lng);
        out.f32(altMsl);
        out.f32(altRel);
        out.f32(roll);
        out.f32(pitch);
        out.f32(yaw);
        out.f32(focLen);
        out.u16(imgIdx);
        out.u8(targetSystem);
        out.u8(camIdx);
        out.u8(flags);
        out.u16(completedCaptures);
    }
}
