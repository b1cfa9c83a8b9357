package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 168, raw fields as on the wire. Generated: see MessageGenerator. */
public record Wind(float direction, float speed, float speedZ) implements Message {
    public static final int ID = 168;

    public static Wind decode(Frame frame) {
        return new Wind(frame.f32(0), frame.f32(4), frame.f32(8));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.f32(direction);
        out.f32(speed);
        out.f32(speedZ);
    }
}
