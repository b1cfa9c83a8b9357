package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 30, raw fields as on the wire. Generated: see MessageGenerator. */
public record Attitude(
        long timeBootMs, float roll, float pitch, float yaw, float rollspeed, float pitchspeed, float yawspeed)
        implements Message {
    public static final int ID = 30;

    public static Attitude decode(Frame frame) {
        return new Attitude(
                frame.u32(0), frame.f32(4), frame.f32(8), frame.f32(12), frame.f32(16), frame.f32(20), frame.f32(24));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeBootMs);
        out.f32(roll);
        out.f32(pitch);
        out.f32(yaw);
        out.f32(rollspeed);
        out.f32(pitchspeed);
        out.f32(yawspeed);
    }
}
