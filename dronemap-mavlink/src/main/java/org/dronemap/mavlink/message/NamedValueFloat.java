package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 251, raw fields as on the wire. Generated: see MessageGenerator. */
public record NamedValueFloat(long timeBootMs, String name, float value) implements Message {
    public static final int ID = 251;

    public static NamedValueFloat decode(Frame frame) {
        return new NamedValueFloat(frame.u32(0), frame.text(8, 10), frame.f32(4));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeBootMs);
        out.f32(value);
        out.text(name, 10);
    }
}
