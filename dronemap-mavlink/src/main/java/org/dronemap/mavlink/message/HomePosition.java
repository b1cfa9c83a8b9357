package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 242, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record HomePosition(
        int latitude,
        int longitude,
        int altitude,
        float x,
        float y,
        float z,
        float[] q,
        float approachX,
        float approachY,
        float approachZ,
        long timeUsec)
        implements Message {
    public static final int ID = 242;

    public static HomePosition decode(Frame frame) {
        return new HomePosition(
                frame.i32(0),
                frame.i32(4),
                frame.i32(8),
                frame.f32(12),
                frame.f32(16),
                frame.f32(20),
                frame.f32s(24, 4),
                frame.f32(40),
                frame.f32(44),
                frame.f32(48),
                frame.i64(52));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i32(latitude);
        out.i32(longitude);
        out.i32(altitude);
        out.f32(x);
        out.f32(y);
        out.f32(z);
        out.f32s(q, 4);
        out.f32(approachX);
        out.f32(approachY);
        out.f32(approachZ);
        out.i64(timeUsec);
    }
}
