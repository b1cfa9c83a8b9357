package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 118, raw fields as on the wire. Generated: see MessageGenerator. */
public record LogEntry(int id, int numLogs, int lastLogNum, long timeUtc, long size) implements Message {
    public static final int ID = 118;

    public static LogEntry decode(Frame frame) {
        return new LogEntry(frame.u16(8), frame.u16(10), frame.u16(12), frame.u32(0), frame.u32(4));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeUtc);
        out.u32(size);
        out.u16(id);
        out.u16(numLogs);
        out.u16(lastLogNum);
    }
}
