package org.dronemap.mavlink.tlog;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;

/**
 * The frame count, times and usable length of a recording, found by walking over its records.
 *
 * @param wholeBytes up to the end of the last whole record; what follows was cut off while it was written
 */
public record TlogScan(long frames, long wholeBytes, long firstMicros, long lastMicros) {
    private static final int TIME = Long.BYTES;
    private static final int LONGEST_HEADER = 10;
    private static final int CHECKSUM = 2;
    private static final int SIGNATURE = 13;

    public static TlogScan of(InputStream recording) throws IOException {
        BufferedInputStream in = new BufferedInputStream(recording, 1 << 16);
        long frames = 0;
        long whole = 0;
        long first = 0;
        long last = 0;
        byte[] time = new byte[TIME];
        while (in.readNBytes(time, 0, TIME) == TIME) {
            int length = skipFrame(in);
            if (length == 0) {
                break;
            }
            last = ByteBuffer.wrap(time).getLong();
            first = frames == 0 ? last : first;
            frames++;
            whole += TIME + length;
        }
        return new TlogScan(frames, whole, first, last);
    }

    /** The frame's length; 0 when there is no whole frame. */
    private static int skipFrame(InputStream in) throws IOException {
        int magic = in.read();
        int payload = in.read();
        int flags = in.read();
        if ((magic != 0xFD && magic != 0xFE) || payload < 0 || flags < 0) {
            return 0;
        }
        int header = magic == 0xFD ? LONGEST_HEADER : LONGEST_HEADER - 4;
        int length = header + payload + CHECKSUM + (magic == 0xFD && (flags & 1) != 0 ? SIGNATURE : 0);
        int rest = length - 3;
        byte[] skipped = in.readNBytes(rest);
        return skipped.length == rest ? length : 0;
    }
}
