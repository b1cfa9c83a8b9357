package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 256, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record SetupSigning(int targetSystem, int targetComponent, int[] secretKey, long initialTimestamp)
        implements Message {
    public static final int ID = 256;

    public static SetupSigning decode(Frame frame) {
        return new SetupSigning(frame.u8(8), frame.u8(9), frame.u8s(10, 32), frame.i64(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(initialTimestamp);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8s(secretKey, 32);
    }
}
