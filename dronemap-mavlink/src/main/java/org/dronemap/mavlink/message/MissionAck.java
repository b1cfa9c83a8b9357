package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 47, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionAck(int targetSystem, int targetComponent, int type, int missionType) implements Message {
    public static final int ID = 47;

    public static MissionAck decode(Frame frame) {
        return new MissionAck(frame.u8(0), frame.u8(1), frame.u8(2), frame.u8(3));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(type);
        out.u8(missionType);
    }
}
