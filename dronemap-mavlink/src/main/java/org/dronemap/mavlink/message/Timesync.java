package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 111, raw fields as on the wire. Generated: see MessageGenerator. */
public record Timesync(long tc1, long ts1, int targetSystem, int targetComponent) implements Message {
    public static final int ID = 111;

    public static Timesync decode(Frame frame) {
        return new Timesync(frame.i64(0), frame.i64(8), frame.u8(16), frame.u8(17));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(tc1);
        out.i64(ts1);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
