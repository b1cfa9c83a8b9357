package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 148, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record AutopilotVersion(
        long capabilities,
        long flightSwVersion,
        long middlewareSwVersion,
        long osSwVersion,
        long boardVersion,
        int[] flightCustomVersion,
        int[] middlewareCustomVersion,
        int[] osCustomVersion,
        int vendorId,
        int productId,
        long uid,
        int[] uid2)
        implements Message {
    public static final int ID = 148;

    public static AutopilotVersion decode(Frame frame) {
        return new AutopilotVersion(
                frame.i64(0),
                frame.u32(16),
                frame.u32(20),
                frame.u32(24),
                frame.u32(28),
                frame.u8s(36, 8),
                frame.u8s(44, 8),
                frame.u8s(52, 8),
                frame.u16(32),
                frame.u16(34),
                frame.i64(8),
                frame.u8s(60, 18));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(capabilities);
        out.i64(uid);
        out.u32(flightSwVersion);
        out.u32(middlewareSwVersion);
        out.u32(osSwVersion);
        out.u32(boardVersion);
        out.u16(vendorId);
        out.u16(productId);
        out.u8s(flightCustomVersion, 8);
        out.u8s(middlewareCustomVersion, 8);
        out.u8s(osCustomVersion, 8);
        out.u8s(uid2, 18);
    }
}
