package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 33, raw fields as on the wire. Generated: see MessageGenerator. */
public record GlobalPositionInt(
        long timeBootMs, int lat, int lon, int alt, int relativeAlt, int vx, int vy, int vz, int hdg)
        implements Message {
    public static final int ID = 33;

    public static GlobalPositionInt decode(Frame frame) {
        return new GlobalPositionInt(
                frame.u32(0),
                frame.i32(4),
                frame.i32(8),
                frame.i32(12),
                frame.i32(16),
                frame.i16(20),
                frame.i16(22),
                frame.i16(24),
                frame.u16(26));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.u32(timeBootMs);
        out.i32(lat);
        out.i32(lon);
        out.i32(alt);
        out.i32(relativeAlt);
        out.i16(vx);
        out.i16(vy);
        out.i16(vz);
        out.u16(hdg);
    }
}
