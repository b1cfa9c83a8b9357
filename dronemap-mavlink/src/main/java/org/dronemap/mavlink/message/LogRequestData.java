package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 119, raw fields as on the wire. Generated: see MessageGenerator. */
public record LogRequestData(int targetSystem, int targetComponent, int id, long ofs, long count) implements Message {
    public static final int ID = 119;

    public static LogRequestData decode(Frame frame) {
        return new LogRequestData(frame.u8(10), frame.u8(11), frame.u16(8), frame.u32(0), frame.u32(4));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(ofs);
        out.u32(count);
        out.u16(id);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
