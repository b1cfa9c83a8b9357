package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 23, raw fields as on the wire. Generated: see MessageGenerator. */
public record ParamSet(int targetSystem, int targetComponent, String paramId, float paramValue, int paramType)
        implements Message {
    public static final int ID = 23;

    public static ParamSet decode(Frame frame) {
        return new ParamSet(frame.u8(4), frame.u8(5), frame.text(6, 16), frame.f32(0), frame.u8(22));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.f32(paramValue);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.text(paramId, 16);
        out.u8(paramType);
    }
}
