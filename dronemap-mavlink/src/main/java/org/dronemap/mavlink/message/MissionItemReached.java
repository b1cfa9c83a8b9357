package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 46, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionItemReached(int seq) implements Message {
    public static final int ID = 46;

    public static MissionItemReached decode(Frame frame) {
        return new MissionItemReached(frame.u16(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(seq);
    }
}
