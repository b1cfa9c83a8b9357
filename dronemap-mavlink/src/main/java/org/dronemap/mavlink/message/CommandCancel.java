package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 80, raw fields as on the wire. Generated: see MessageGenerator. */
public record CommandCancel(int targetSystem, int targetComponent, int command) implements Message {
    public static final int ID = 80;

    public static CommandCancel decode(Frame frame) {
        return new CommandCancel(frame.u8(2), frame.u8(3), frame.u16(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(command);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
