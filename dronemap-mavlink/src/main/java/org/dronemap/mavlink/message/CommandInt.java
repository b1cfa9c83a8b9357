package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 75, raw fields as on the wire. Generated: see MessageGenerator. */
public record CommandInt(
        int targetSystem,
        int targetComponent,
        int frame,
        int command,
        int current,
        int autocontinue,
        float param1,
        float param2,
        float param3,
        float param4,
        int x,
        int y,
        float z)
        implements Message {
    public static final int ID = 75;

    public static CommandInt decode(Frame frame) {
        return new CommandInt(
                frame.u8(30),
                frame.u8(31),
                frame.u8(32),
                frame.u16(28),
                frame.u8(33),
                frame.u8(34),
                frame.f32(0),
                frame.f32(4),
                frame.f32(8),
                frame.f32(12),
                frame.i32(16),
                frame.i32(20),
                frame.f32(24));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.f32(param1);
        out.f32(param2);
        out.f32(param3);
        out.f32(param4);
        out.i32(x);
        out.i32(y);
        out.f32(z);
        out.u16(command);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(frame);
        out.u8(current);
        out.u8(autocontinue);
    }
}
