package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 38, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionWritePartialList(
        int targetSystem, int targetComponent, int startIndex, int endIndex, int missionType) implements Message {
    public static final int ID = 38;

    public static MissionWritePartialList decode(Frame frame) {
        return new MissionWritePartialList(frame.u8(4), frame.u8(5), frame.i16(0), frame.i16(2), frame.u8(6));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i16(startIndex);
        out.i16(endIndex);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(missionType);
    }
}
