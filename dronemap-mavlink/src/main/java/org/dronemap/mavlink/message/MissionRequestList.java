package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 43, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionRequestList(int targetSystem, int targetComponent, int missionType) implements Message {
    public static final int ID = 43;

    public static MissionRequestList decode(Frame frame) {
        return new MissionRequestList(frame.u8(0), frame.u8(1), frame.u8(2));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(missionType);
    }
}
