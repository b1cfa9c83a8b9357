package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 231, raw fields as on the wire. Generated: see MessageGenerator. */
public record WindCov(
        long timeUsec,
        float windX,
        float windY,
        float windZ,
        float varHoriz,
        float varVert,
        float windAlt,
        float horizAccuracy,
        float vertAccuracy)
        implements Message {
    public static final int ID = 231;

    public static WindCov decode(Frame frame) {
        return new WindCov(
                frame.i64(0),
                frame.f32(8),
                frame.f32(12),
                frame.f32(16),
                frame.f32(20),
                frame.f32(24),
                frame.f32(28),
                frame.f32(32),
                frame.f32(36));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUsec);
        out.f32(windX);
        out.f32(windY);
        out.f32(windZ);
        out.f32(varHoriz);
        out.f32(varVert);
        out.f32(windAlt);
        out.f32(horizAccuracy);
        out.f32(vertAccuracy);
    }
}
