package org.dronemap.mavlink.message;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** MAVLink message 263, raw fields as on the wire. Generated: see MessageGenerator. */
@SuppressWarnings("ArrayRecordComponent")
public record CameraImageCaptured(
        long timeBootMs,
        long timeUtc,
        int cameraId,
        int lat,
        int lon,
        int alt,
        int relativeAlt,
        float[] q,
        int imageIndex,
        int captureResult,
        String fileUrl)
        implements Message {
    public static final int ID = 263;

    public static CameraImageCaptured decode(Frame frame) {
        return new CameraImageCaptured(
                frame.u32(8),
                frame.i64(0),
                frame.u8(48),
                frame.i32(12),
                frame.i32(16),
                frame.i32(20),
                frame.i32(24),
                frame.f32s(28, 4),
                frame.i32(44),
                frame.i8(49),
                frame.text(50, 205));
    }

    @Override
    public int messageId() {
        return ID;
    }

    @Override
    public void write(PayloadWriter out) {
        out.i64(timeUtc);
        out.u32(timeBootMs);
        out.i32(lat);
        out.i32(lon);
        out.i32(alt);
        out.i32(relativeAlt);
        out.f32s(q, 4);
        out.i32(imageIndex);
        out.u8(cameraId);
        out.i8(captureResult);
        out.text(fileUrl, 205);
    }
}
