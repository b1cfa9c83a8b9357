package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 70, raw fields as on the wire. Generated: see MessageGenerator. */
public record RcChannelsOverride(
        int targetSystem,
        int targetComponent,
        int chan1Raw,
        int chan2Raw,
        int chan3Raw,
        int chan4Raw,
        int chan5Raw,
        int chan6Raw,
        int chan7Raw,
        int chan8Raw,
        int chan9Raw,
        int chan10Raw,
        int chan11Raw,
        int chan12Raw,
        int chan13Raw,
        int chan14Raw,
        int chan15Raw,
        int chan16Raw,
        int chan17Raw,
        int chan18Raw)
        implements Message {
    public static final int ID = 70;

    public static RcChannelsOverride decode(Frame frame) {
        return new RcChannelsOverride(
                frame.u8(16),
                frame.u8(17),
                frame.u16(0),
                frame.u16(2),
                frame.u16(4),
                frame.u16(6),
                frame.u16(8),
                frame.u16(10),
                frame.u16(12),
                frame.u16(14),
                frame.u16(18),
                frame.u16(20),
                frame.u16(22),
                frame.u16(24),
                frame.u16(26),
                frame.u16(28),
                frame.u16(30),
                frame.u16(32),
                frame.u16(34),
                frame.u16(36));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(chan1Raw);
        out.u16(chan2Raw);
        out.u16(chan3Raw);
        out.u16(chan4Raw);
        out.u16(chan5Raw);
        out.u16(chan6Raw);
        out.u16(chan7Raw);
        out.u16(chan8Raw);
        out.u8(targetSystem);
        out.u8(targetComponent);
        out.u16(chan9Raw);
        out.u16(chan10Raw);
        out.u16(chan11Raw);
        out.u16(chan12Raw);
        out.u16(chan13Raw);
        out.u16(chan14Raw);
        out.u16(chan15Raw);
        out.u16(chan16Raw);
        out.u16(chan17Raw);
        out.u16(chan18Raw);
    }
}
