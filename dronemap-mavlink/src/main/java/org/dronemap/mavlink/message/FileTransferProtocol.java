package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 110, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record FileTransferProtocol(int targetNetwork, int targetSystem, int targetComponent, int[] payload)
        implements Message {
    public static final int ID = 110;

    public static FileTransferProtocol decode(Frame frame) {
        return new FileTransferProtocol(frame.u8(0), frame.u8(1), frame.u8(2), frame.u8s(3, 251));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u8(targetNetwork);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8s(payload, 251);
    }
}
