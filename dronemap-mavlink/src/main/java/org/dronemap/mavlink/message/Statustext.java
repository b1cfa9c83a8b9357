package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 253, raw fields as on the wire. Generated: see MessageGenerator. */
public record Statustext(int severity, String text, int id, int chunkSeq) implements Message {
    public static final int ID = 253;

    public static Statustext decode(Frame frame) {
        return new Statustext(frame.u8(0), frame.text(1, 50), frame.u16(51), frame.u8(53));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(severity);
        out.text(text, 50);
        out.u16(id);
        out.u8(chunkSeq);
    }
}
