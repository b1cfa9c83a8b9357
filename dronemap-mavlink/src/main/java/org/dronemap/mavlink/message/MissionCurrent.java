package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 42, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionCurrent(int seq, int total, int missionState, int missionMode) implements Message {
    public static final int ID = 42;

    public static MissionCurrent decode(Frame frame) {
        return new MissionCurrent(frame.u16(0), frame.u16(2), frame.u8(4), frame.u8(5));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(seq);
        out.u16(total);
        out.u8(missionState);
        out.u8(missionMode);
    }
}
