package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 122, raw fields as on the wire. Generated: see MessageGenerator. */
public record LogRequestEnd(int targetSystem, int targetComponent) implements Message {
    public static final int ID = 122;

    public static LogRequestEnd decode(Frame frame) {
        return new LogRequestEnd(frame.u8(0), frame.u8(1));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
