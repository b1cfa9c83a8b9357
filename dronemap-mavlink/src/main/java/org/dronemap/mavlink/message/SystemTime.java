package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 2, raw fields as on the wire. Generated: see MessageGenerator. */
public record SystemTime(long timeUnixUsec, long timeBootMs) implements Message {
    public static final int ID = 2;

    public static SystemTime decode(Frame frame) {
        return new SystemTime(frame.i64(0), frame.u32(8));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUnixUsec);
        out.u32(timeBootMs);
    }
}
