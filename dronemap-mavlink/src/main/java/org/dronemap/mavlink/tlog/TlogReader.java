package org.dronemap.mavlink.tlog;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.jspecify.annotations.Nullable;

/**
 * Reads a tlog, the usual recording format of MAVLink: records of 8 bytes big-endian microseconds and a raw frame.
 * Where bytes are broken it finds the next good frame by itself; the time is then the one that stands before that
 * frame. Not thread-safe.
 */
public final class TlogReader {
    private static final int CHUNK = 8192;
    /** 2000 to 2100 in microseconds: a time outside is no time but broken bytes. */
    private static final long EARLIEST_MICROS = 946_684_800_000_000L;

    private static final long LATEST_MICROS = 4_102_444_800_000_000L;

    private final InputStream in;
    private final FrameReader reader = new FrameReader(Long.BYTES);
    private final ArrayDeque<Timed> ready = new ArrayDeque<>();
    private final byte[] chunk = new byte[CHUNK];
    private final byte[] lastEight = new byte[8];
    private long lastMicros;
    private long bytesRead;
    private boolean ended;
    private long brokenRuns;
    private long brokenBytes;
    private long skippedBefore;

    /** One frame with its time in microseconds since 1970. */
    public record Timed(long micros, Frame frame) {}

    public TlogReader(InputStream in) {
        this.in = in;
    }

    /** The next record; null at the end. */
    public @Nullable Timed next() throws IOException {
        while (ready.isEmpty() && !ended) {
            int count = in.read(chunk);
            if (count < 0) {
                ended = true;
                reader.endOfInput(this::add);
            } else {
                bytesRead += count;
                reader.read(ByteBuffer.wrap(chunk, 0, count), this::add);
            }
        }
        return ready.poll();
    }

    /** Bytes taken from the stream so far. */
    public long bytesRead() {
        return bytesRead;
    }

    /** Counts of frames and broken bytes; the times between frames are no broken bytes. */
    public Counts counts() {
        FrameReader.Counts counts = reader.counts();
        return new Counts(counts.goodFrames(), counts.unverifiedFrames(), brokenRuns, brokenBytes);
    }

    /** Good frames have a right checksum; unverified ones are of unknown messages. */
    public record Counts(long goodFrames, long unverifiedFrames, long brokenRuns, long brokenBytes) {}

    private void add(Frame frame) {
        long skipped = reader.counts().skippedBytes() - skippedBefore;
        skippedBefore += skipped;
        if (skipped > 8) {
            brokenRuns++;
            brokenBytes += skipped - 8;
        }
        ready.add(new Timed(time(), frame));
    }

    private long time() {
        reader.copyLastSkipped(lastEight);
        long micros = ByteBuffer.wrap(lastEight).getLong();
        if (micros >= EARLIEST_MICROS && micros < LATEST_MICROS) {
            lastMicros = micros;
        }
        return lastMicros;
    }
}
