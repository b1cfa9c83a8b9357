package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 40, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionRequest(int targetSystem, int targetComponent, int seq, int missionType) implements Message {
    public static final int ID = 40;

    public static MissionRequest decode(Frame frame) {
        return new MissionRequest(frame.u8(2), frame.u8(3), frame.u16(0), frame.u8(4));
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
        out.u8(missionType);
    }
}
