package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 24, raw fields as on the wire. Generated: see MessageGenerator. */
public record GpsRawInt(
        long timeUsec,
        int fixType,
        int lat,
        int lon,
        int alt,
        int eph,
        int epv,
        int vel,
        int cog,
        int satellitesVisible,
        int altEllipsoid,
        long hAcc,
        long vAcc,
        long velAcc,
        long hdgAcc,
        int yaw)
        implements Message {
    public static final int ID = 24;

    public static GpsRawInt decode(Frame frame) {
        return new GpsRawInt(
                frame.i64(0),
                frame.u8(28),
                frame.i32(8),
                frame.i32(12),
                frame.i32(16),
                frame.u16(20),
                frame.u16(22),
                frame.u16(24),
                frame.u16(26),
                frame.u8(29),
                frame.i32(30),
                frame.u32(34),
                frame.u32(38),
                frame.u32(42),
                frame.u32(46),
                frame.u16(50));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUsec);
        out.i32(lat);
        out.i32(lon);
        out.i32(alt);
        out.u16(eph);
        out.u16(epv);
        out.u16(vel);
        out.u16(cog);
        out.u8(fixType);
        out.u8(satellitesVisible);
        out.i32(altEllipsoid);
        out.u32(hAcc);
        out.u32(vAcc);
        out.u32(velAcc);
        out.u32(hdgAcc);
        out.u16(yaw);
    }
}
