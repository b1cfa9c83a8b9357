package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 4, raw fields as on the wire. Generated: see MessageGenerator. */
public record Ping(long timeUsec, long seq, int targetSystem, int targetComponent) implements Message {
    public static final int ID = 4;

    public static Ping decode(Frame frame) {
        return new Ping(frame.i64(0), frame.u32(8), frame.u8(12), frame.u8(13));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUsec);
        out.u32(seq);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
