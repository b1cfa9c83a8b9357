package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 66, raw fields as on the wire. Generated: see MessageGenerator. */
public record RequestDataStream(
        int targetSystem, int targetComponent, int reqStreamId, int reqMessageRate, int startStop) implements Message {
    public static final int ID = 66;

    public static RequestDataStream decode(Frame frame) {
        return new RequestDataStream(frame.u8(2), frame.u8(3), frame.u8(4), frame.u16(0), frame.u8(5));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(reqMessageRate);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(reqStreamId);
        out.u8(startStop);
    }
}
