package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 0, raw fields as on the wire. Generated: see MessageGenerator. */
public record Heartbeat(int type, int autopilot, int baseMode, long customMode, int systemStatus, int mavlinkVersion)
        implements Message {
    public static final int ID = 0;

    public static Heartbeat decode(Frame frame) {
        return new Heartbeat(frame.u8(4), frame.u8(5), frame.u8(6), frame.u32(0), frame.u8(7), frame.u8(8));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(customMode);
        out.u8(type);
        out.u8(autopilot);
        out.u8(baseMode);
        out.u8(systemStatus);
        out.u8(mavlinkVersion);
    }
}
