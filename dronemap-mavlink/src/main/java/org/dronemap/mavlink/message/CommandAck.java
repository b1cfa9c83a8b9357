package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 77, raw fields as on the wire. Generated: see MessageGenerator. */
public record CommandAck(int command, int result, int progress, int resultParam2, int targetSystem, int targetComponent)
        implements Message {
    public static final int ID = 77;

    public static CommandAck decode(Frame frame) {
        return new CommandAck(frame.u16(0), frame.u8(2), frame.u8(3), frame.i32(4), frame.u8(8), frame.u8(9));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(command);
        out.u8(result);
        out.u8(progress);
        out.i32(resultParam2);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
