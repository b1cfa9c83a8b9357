package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 69, raw fields as on the wire. Generated: see MessageGenerator. */
public record ManualControl(
        int target, int x, int y, int z, int r, int buttons, int buttons2, int enabledExtensions, int s, int t)
        implements Message {
    public static final int ID = 69;

    public static ManualControl decode(Frame frame) {
        return new ManualControl(
                frame.u8(10),
                frame.i16(0),
                frame.i16(2),
                frame.i16(4),
                frame.i16(6),
                frame.u16(8),
                frame.u16(11),
                frame.u8(13),
                frame.i16(14),
                frame.i16(16));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i16(x);
        out.i16(y);
        out.i16(z);
        out.i16(r);
        out.u16(buttons);
        out.u8(target);
        out.u16(buttons2);
        out.u8(enabledExtensions);
        out.i16(s);
        out.i16(t);
    }
}
