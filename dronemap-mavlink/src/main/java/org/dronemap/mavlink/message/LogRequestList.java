package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 117, raw fields as on the wire. Generated: see MessageGenerator. */
public record LogRequestList(int targetSystem, int targetComponent, int start, int end) implements Message {
    public static final int ID = 117;

    public static LogRequestList decode(Frame frame) {
        return new LogRequestList(frame.u8(4), frame.u8(5), frame.u16(0), frame.u16(2));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(start);
        out.u16(end);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
