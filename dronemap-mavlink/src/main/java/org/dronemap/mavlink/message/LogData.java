package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 120, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record LogData(int id, long ofs, int count, int[] data) implements Message {
    public static final int ID = 120;

    public static LogData decode(Frame frame) {
        return new LogData(frame.u16(4), frame.u32(0), frame.u8(6), frame.u8s(7, 90));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(ofs);
        out.u16(id);
        out.u8(count);
        out.u8s(data, 90);
    }
}
