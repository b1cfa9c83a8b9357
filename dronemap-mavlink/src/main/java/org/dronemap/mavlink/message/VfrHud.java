package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 74, raw fields as on the wire. Generated: see MessageGenerator. */
public record VfrHud(float airspeed, float groundspeed, int heading, int throttle, float alt, float climb)
        implements Message {
    public static final int ID = 74;

    public static VfrHud decode(Frame frame) {
        return new VfrHud(frame.f32(0), frame.f32(4), frame.i16(16), frame.u16(18), frame.f32(8), frame.f32(12));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.f32(airspeed);
        out.f32(groundspeed);
        out.f32(alt);
        out.f32(climb);
        out.i16(heading);
        out.u16(throttle);
    }
}
