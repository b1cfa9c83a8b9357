package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 36, raw fields as on the wire. Generated: see MessageGenerator. */
public record ServoOutputRaw(
        long timeUsec,
        int port,
        int servo1Raw,
        int servo2Raw,
        int servo3Raw,
        int servo4Raw,
        int servo5Raw,
        int servo6Raw,
        int servo7Raw,
        int servo8Raw,
        int servo9Raw,
        int servo10Raw,
        int servo11Raw,
        int servo12Raw,
        int servo13Raw,
        int servo14Raw,
        int servo15Raw,
        int servo16Raw)
        implements Message {
    public static final int ID = 36;

    public static ServoOutputRaw decode(Frame frame) {
        return new ServoOutputRaw(
                frame.u32(0),
                frame.u8(20),
                frame.u16(4),
                frame.u16(6),
                frame.u16(8),
                frame.u16(10),
                frame.u16(12),
                frame.u16(14),
                frame.u16(16),
                frame.u16(18),
                frame.u16(21),
                frame.u16(23),
                frame.u16(25),
                frame.u16(27),
                frame.u16(29),
                frame.u16(31),
                frame.u16(33),
                frame.u16(35));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeUsec);
        out.u16(servo1Raw);
        out.u16(servo2Raw);
        out.u16(servo3Raw);
        out.u16(servo4Raw);
        out.u16(servo5Raw);
        out.u16(servo6Raw);
        out.u16(servo7Raw);
        out.u16(servo8Raw);
        out.u8(port);
        out.u16(servo9Raw);
        out.u16(servo10Raw);
        out.u16(servo11Raw);
        out.u16(servo12Raw);
        out.u16(servo13Raw);
        out.u16(servo14Raw);
        out.u16(servo15Raw);
        out.u16(servo16Raw);
    }
}
