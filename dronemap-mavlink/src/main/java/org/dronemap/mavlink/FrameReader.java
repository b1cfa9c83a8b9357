package org.dronemap.mavlink;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Parses MAVLink frames from a byte stream, in which they may be split, packed together or broken. Broken bytes are
 * counted and skipped: after a frame with a wrong checksum the search goes on right behind its first byte, so that a
 * lying length swallows nothing. Not thread-safe.
 */
public final class FrameReader {
    private static final int LONGEST = Frame.HEADER_2 + 255 + 2 + Frame.SIGNATURE_BYTES;

    private final int gapBytes;
    private final byte[] pending = new byte[4 * LONGEST];
    private int start;
    private int end;
    private long goodFrames;
    private long unverifiedFrames;
    private long brokenFrames;
    private long skippedBytes;
    private long skippedRuns;
    private boolean skipping;
    private boolean atGap;
    private final byte[] lastSkipped = new byte[8];

    /** Counts since the start; bytes that belong to no frame come in runs. */
    public record Counts(
            long goodFrames, long unverifiedFrames, long brokenFrames, long skippedBytes, long skippedRuns) {}

    public FrameReader() {
        this(0);
    }

    /** {@code gapBytes}: what stands before each frame and is none of it, as the time in recordings. */
    public FrameReader(int gapBytes) {
        this.gapBytes = gapBytes;
        atGap = gapBytes > 0;
    }

    /** Takes bytes in and hands every frame that they complete to {@code frames}, in order. */
    public void read(ByteBuffer bytes, Consumer<Frame> frames) {
        while (bytes.hasRemaining()) {
            makeRoom();
            int taken = Math.min(bytes.remaining(), pending.length - end);
            bytes.get(pending, end, taken);
            end += taken;
            parse(frames, false);
        }
    }

    /**
     * Takes one datagram in. A frame may go on over datagrams, but one that by itself begins with a good frame ends the
     * wait for an earlier frame: a length byte that lied must not hold a slow vehicle's heartbeats back.
     */
    public void readDatagram(ByteBuffer datagram, Consumer<Frame> frames) {
        if (start < end && beginsWithGoodFrame(datagram)) {
            endOfInput(frames);
        }
        read(datagram, frames);
    }

    /** The input has ended (or a datagram that nothing can continue): what is left over is searched and dropped. */
    public void endOfInput(Consumer<Frame> frames) {
        parse(frames, true);
    }

    public Counts counts() {
        return new Counts(goodFrames, unverifiedFrames, brokenFrames, skippedBytes, skippedRuns);
    }

    /** The last eight bytes that belonged to no frame, oldest first: in recordings that is the time of a frame. */
    public void copyLastSkipped(byte[] into) {
        for (int i = 0; i < 8; i++) {
            into[i] = lastSkipped[(int) ((skippedBytes + i) & 7)];
        }
    }

    private static boolean beginsWithGoodFrame(ByteBuffer datagram) {
        byte[] head = new byte[Math.min(datagram.remaining(), LONGEST)];
        datagram.get(datagram.position(), head);
        return isGoodFrameAt(head, 0, head.length);
    }

    private void makeRoom() {
        if (start > 0) {
            System.arraycopy(pending, start, pending, 0, end - start);
            end -= start;
            start = 0;
        }
    }

    private void parse(Consumer<Frame> frames, boolean last) {
        while (start < end) {
            if (atGap && !passGap(last)) {
                return;
            }
            int need = lengthAt(pending, start, end);
            if (need == 0) {
                skip();
            } else if (need < 0 || end - start < need) {
                if (!last) {
                    return;
                }
                skip();
            } else {
                emit(need, frames);
            }
        }
    }

    /**
     * Skips the gap unseen when a good frame follows: it may look like a frame itself, and would swallow what comes after
     * it. False when that cannot be told yet.
     */
    private boolean passGap(boolean last) {
        int at = start + gapBytes;
        int need = at < end ? lengthAt(pending, at, end) : -1;
        if (!last && (need < 0 || at + need > end)) {
            return false;
        }
        atGap = false;
        if (isGoodFrameAt(pending, at, end)) {
            for (int i = 0; i < gapBytes; i++) {
                skip();
            }
        }
        return true;
    }

    /** Whole frame length at this place; 0: no frame begins here, -1: cannot be told yet. */
    private static int lengthAt(byte[] bytes, int at, int end) {
        int magic = bytes[at] & 0xFF;
        if (magic == Frame.MAGIC_1) {
            return end - at < 2 ? -1 : Frame.HEADER_1 + (bytes[at + 1] & 0xFF) + 2;
        }
        if (magic != Frame.MAGIC_2) {
            return 0;
        }
        if (end - at < 3) {
            return -1;
        }
        int flags = bytes[at + 2] & 0xFF;
        if ((flags & ~Frame.SIGNED_FLAG) != 0) {
            // An incompatibility flag that is not known: the frame must be dropped.
            return 0;
        }
        return Frame.HEADER_2 + (bytes[at + 1] & 0xFF) + 2 + (flags != 0 ? Frame.SIGNATURE_BYTES : 0);
    }

    private void emit(int length, Consumer<Frame> frames) {
        boolean v2 = (pending[start] & 0xFF) == Frame.MAGIC_2;
        MessageTable.Entry entry = MessageTable.find(messageIdAt(pending, start, v2));
        if (entry == null ? !isBelievable(start + length) : !checksumHolds(pending, start, v2, entry)) {
            brokenFrames++;
            skip();
            return;
        }
        Frame frame = new Frame(Arrays.copyOfRange(pending, start, start + length), entry != null);
        start += length;
        skipping = false;
        atGap = gapBytes > 0;
        if (entry != null) {
            goodFrames++;
        } else {
            unverifiedFrames++;
        }
        frames.accept(frame);
    }

    /** A frame that cannot be checked is believed only between frames, and when it hides no good frame. */
    private boolean isBelievable(int next) {
        if (skipping || (next < end && !isMagic(pending[next]))) {
            return false;
        }
        for (int inside = start + 1; inside < next; inside++) {
            if (isGoodFrameAt(pending, inside, end)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isMagic(byte octet) {
        return (octet & 0xFF) == Frame.MAGIC_1 || (octet & 0xFF) == Frame.MAGIC_2;
    }

    private static boolean isGoodFrameAt(byte[] bytes, int at, int end) {
        if (at >= end || !isMagic(bytes[at])) {
            return false;
        }
        int length = lengthAt(bytes, at, end);
        if (length <= 0 || end - at < length) {
            return false;
        }
        boolean v2 = (bytes[at] & 0xFF) == Frame.MAGIC_2;
        MessageTable.Entry entry = MessageTable.find(messageIdAt(bytes, at, v2));
        return entry != null && checksumHolds(bytes, at, v2, entry);
    }

    private static int messageIdAt(byte[] bytes, int at, boolean v2) {
        return v2
                ? (bytes[at + 7] & 0xFF) | (bytes[at + 8] & 0xFF) << 8 | (bytes[at + 9] & 0xFF) << 16
                : bytes[at + 5] & 0xFF;
    }

    private static boolean checksumHolds(byte[] bytes, int at, boolean v2, MessageTable.Entry entry) {
        int covered = (v2 ? Frame.HEADER_2 : Frame.HEADER_1) - 1 + (bytes[at + 1] & 0xFF);
        int crc = Crc.add(Crc.add(Crc.START, bytes, at + 1, covered), entry.checksumSeed());
        int check = at + 1 + covered;
        return (bytes[check] & 0xFF) == (crc & 0xFF) && (bytes[check + 1] & 0xFF) == (crc >>> 8);
    }

    private void skip() {
        if (!skipping) {
            skipping = true;
            skippedRuns++;
        }
        lastSkipped[(int) (skippedBytes & 7)] = pending[start];
        skippedBytes++;
        start++;
    }
}
