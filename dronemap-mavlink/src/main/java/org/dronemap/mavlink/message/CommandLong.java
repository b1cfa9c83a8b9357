package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 76, raw fields as on the wire. Generated: see MessageGenerator. */
public record CommandLong(
        int targetSystem,
        int targetComponent,
        int command,
        int confirmation,
        float param1,
        float param2,
        float param3,
        float param4,
        float param5,
        float param6,
        float param7)
        implements Message {
    public static final int ID = 76;

    public static CommandLong decode(Frame frame) {
        return new CommandLong(
                frame.u8(30),
                frame.u8(31),
                frame.u16(28),
                frame.u8(32),
                frame.f32(0),
                frame.f32(4),
                frame.f32(8),
                frame.f32(12),
                frame.f32(16),
                frame.f32(20),
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
        out.f32(param5);
        out.f32(param6);
        out.f32(param7);
        out.u16(command);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(confirmation);
    }
}
