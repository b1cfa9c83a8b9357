package org.dronemap.mavlink.tlog;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.Arrays;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.SignatureStripper;

/**
 * A buffer of tlog records (8 bytes big-endian microseconds since 1970 and one frame) to be written to a recording.
 * Frames are kept byte for byte, but for what would help to guess a signing key: signatures are taken off, and
 * SETUP_SIGNING, which carries the key itself, is left out. Grows up to a bound. Not thread-safe.
 */
public final class TlogBuffer {
    private static final int TIME = Long.BYTES;
    private static final int SETUP_SIGNING = 256;
    private static final int SMALLEST = 1_024;
    private static final int USUAL = 65_536;

    private final int mostBytes;
    private byte[] bytes = new byte[0];
    private int length;
    private int frames;
    private long firstMicros;
    private long lastMicros;

    public TlogBuffer(int mostBytes) {
        this.mostBytes = mostBytes;
    }

    /** False when there is no room. */
    public boolean add(long micros, Frame frame) {
        if (frame.messageId() == SETUP_SIGNING) {
            return true;
        }
        if (!makeRoom(TIME + frame.length())) {
            return false;
        }
        frame.writeTo(begin(micros));
        finish(micros, frame.length());
        return true;
    }

    /** The same for a frame as it goes out. */
    public boolean add(long micros, byte[] frame) {
        if (isSetupSigning(frame)) {
            return true;
        }
        if (!makeRoom(TIME + frame.length)) {
            return false;
        }
        begin(micros).put(frame);
        finish(micros, frame.length);
        return true;
    }

    /** Of a recording in another form: the record is kept as it is, and holds its time itself. */
    public boolean addWhole(long micros, byte[] record) {
        if (!makeRoom(record.length)) {
            return false;
        }
        System.arraycopy(record, 0, bytes, length, record.length);
        if (frames == 0) {
            firstMicros = micros;
        }
        length += record.length;
        lastMicros = micros;
        frames++;
        return true;
    }

    private static boolean isSetupSigning(byte[] frame) {
        return (frame[0] & 0xFF) == 0xFD && frame[7] == (byte) SETUP_SIGNING && frame[8] == 1 && frame[9] == 0;
    }

    private boolean makeRoom(int more) {
        int needed = length + more;
        if (needed > mostBytes) {
            return false;
        }
        if (needed > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.min(mostBytes, Math.max(SMALLEST, Math.max(needed, 2 * bytes.length))));
        }
        return true;
    }

    private ByteBuffer begin(long micros) {
        return ByteBuffer.wrap(bytes, length, bytes.length - length).putLong(micros);
    }

    private void finish(long micros, int frameLength) {
        if (frames == 0) {
            firstMicros = micros;
        }
        length += TIME + SignatureStripper.strip(bytes, length + TIME, frameLength);
        lastMicros = micros;
        frames++;
    }

    /** Moves all of {@code other} behind what is here; false, and nothing is moved, when there is no room. */
    public boolean addAll(TlogBuffer other) {
        if (other.frames == 0) {
            return true;
        }
        if (!makeRoom(other.length)) {
            return false;
        }
        System.arraycopy(other.bytes, 0, bytes, length, other.length);
        if (frames == 0) {
            firstMicros = other.firstMicros;
        }
        length += other.length;
        frames += other.frames;
        lastMicros = other.lastMicros;
        other.clear();
        return true;
    }

    public int frames() {
        return frames;
    }

    public int length() {
        return length;
    }

    /** Time of the first record; meaningless while empty. */
    public long firstMicros() {
        return firstMicros;
    }

    /** Time of the last record; meaningless while empty. */
    public long lastMicros() {
        return lastMicros;
    }

    /** Writes all of it, and keeps it: {@link #clear} when that went well. */
    public void writeTo(WritableByteChannel channel) throws IOException {
        ByteBuffer all = ByteBuffer.wrap(bytes, 0, length);
        while (all.hasRemaining()) {
            channel.write(all);
        }
    }

    /** Empty again; what grew beyond the usual is given back. */
    public void clear() {
        length = 0;
        frames = 0;
        if (bytes.length > USUAL) {
            bytes = new byte[0];
        }
    }
}
