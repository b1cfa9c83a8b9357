package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 51, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionRequestInt(int targetSystem, int targetComponent, int seq, int missionType) implements Message {
    public static final int ID = 51;

    public static MissionRequestInt decode(Frame frame) {
        return new MissionRequestInt(frame.u8(2), frame.u8(3), frame.u16(0), frame.u8(4));
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
