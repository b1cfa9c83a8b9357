package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 41, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionSetCurrent(int targetSystem, int targetComponent, int seq) implements Message {
    public static final int ID = 41;

    public static MissionSetCurrent decode(Frame frame) {
        return new MissionSetCurrent(frame.u8(2), frame.u8(3), frame.u16(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(seq);
        out.u8(targetSystem);
        out.u8(targetComponent);
    }
}
