package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 20, raw fields as on the wire. Generated: see MessageGenerator. */
public record ParamRequestRead(int targetSystem, int targetComponent, String paramId, int paramIndex)
        implements Message {
    public static final int ID = 20;

    public static ParamRequestRead decode(Frame frame) {
        return new ParamRequestRead(frame.u8(2), frame.u8(3), frame.text(4, 16), frame.i16(0));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i16(paramIndex);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.text(paramId, 16);
    }
}
