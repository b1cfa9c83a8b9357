package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 39, raw fields as on the wire. Generated: see MessageGenerator. */
public record MissionItem(
        int targetSystem,
        int targetComponent,
        int seq,
        int frame,
        int command,
        int current,
        int autocontinue,
        float param1,
        float param2,
        float param3,
        float param4,
        float x,
        float y,
        float z,
        int missionType)
        implements Message {
    public static final int ID = 39;

    public static MissionItem decode(Frame frame) {
        return new MissionItem(
                frame.u8(32),
                frame.u8(33),
                frame.u16(28),
                frame.u8(34),
                frame.u16(30),
                frame.u8(35),
                frame.u8(36),
                frame.f32(0),
                frame.f32(4),
                frame.f32(8),
                frame.f32(12),
                frame.f32(16),
                frame.f32(20),
                frame.f32(24),
                frame.u8(37));
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
        out.f32(x);
        out.f32(y);
        out.f32(z);
        out.u16(seq);
        out.u16(command);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u8(frame);
        out.u8(current);
        out.u8(autocontinue);
        out.u8(missionType);
    }
}
