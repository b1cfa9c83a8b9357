package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 11, raw fields as on the wire. Generated: see MessageGenerator. */
public record SetMode(int targetSystem, int baseMode, long customMode) implements Message {
    public static final int ID = 11;

    public static SetMode decode(Frame frame) {
        return new SetMode(frame.u8(4), frame.u8(5), frame.u32(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(customMode);
        out.u8(targetSystem);
        out.u8(baseMode);
    }
}
