package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 245, raw fields as on the wire. Generated: see MessageGenerator. */
public record ExtendedSysState(int vtolState, int landedState) implements Message {
    public static final int ID = 245;

    public static ExtendedSysState decode(Frame frame) {
        return new ExtendedSysState(frame.u8(0), frame.u8(1));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(vtolState);
        out.u8(landedState);
    }
}
