package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 109, raw fields as on the wire. Generated: see MessageGenerator. */
public record RadioStatus(int rssi, int remrssi, int txbuf, int noise, int remnoise, int rxerrors, int fixed)
        implements Message {
    public static final int ID = 109;

    public static RadioStatus decode(Frame frame) {
        return new RadioStatus(
                frame.u8(4), frame.u8(5), frame.u8(6), frame.u8(7), frame.u8(8), frame.u16(0), frame.u16(2));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u16(rxerrors);
        out.u16(fixed);
        out.u8(rssi);
        out.u8(remrssi);
        out.u8(txbuf);
        out.u8(noise);
        out.u8(remnoise);
    }
}
