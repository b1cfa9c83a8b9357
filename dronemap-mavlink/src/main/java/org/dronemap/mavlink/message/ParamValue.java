package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 22, raw fields as on the wire. Generated: see MessageGenerator. */
public record ParamValue(String paramId, float paramValue, int paramType, int paramCount, int paramIndex)
        implements Message {
    public static final int ID = 22;

    public static ParamValue decode(Frame frame) {
        return new ParamValue(frame.text(8, 16), frame.f32(0), frame.u8(24), frame.u16(4), frame.u16(6));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.f32(paramValue);
        out.u16(paramCount);
        out.u16(paramIndex);
        out.text(paramId, 16);
        out.u8(paramType);
    }
}
