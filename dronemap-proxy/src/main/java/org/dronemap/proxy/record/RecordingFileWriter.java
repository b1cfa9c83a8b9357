package org.dronemap.proxy.record;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.mavlink.tlog.TlogBuffer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes one recording of a drone to its file, until the flight is over. Owned by the writer; {@link #recording} may be
 * read from anywhere.
 */
final class RecordingFileWriter {
    private static final Logger LOG = LoggerFactory.getLogger(RecordingFileWriter.class);

    private final Path file;
    private @Nullable FileChannel channel;
    private @Nullable SentFrameIndex sent;
    private long lastMicros;
    private @Nullable String failure;
    private volatile Recording recording;

    private RecordingFileWriter(Path file, Recording recording) {
        this.file = file;
        this.recording = recording;
    }

    /** Never throws: one that cannot be written says so in its record and counts what is missing. */
    static RecordingFileWriter open(RecordingFiles files, DroneId drone, String droneName, long startMicros) {
        Instant start = instant(startMicros);
        for (int number = 1; ; number++) {
            String id = files.id(start, drone, number);
            RecordingFileWriter opened = new RecordingFileWriter(
                    files.newPath(id),
                    new Recording(id, drone, droneName, start, null, 0, 0, 0, Recording.State.RUNNING, null));
            try {
                opened.channel = FileChannel.open(opened.file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                opened.sent = SentFrameIndex.open(files.sentPath(id));
                return opened;
            } catch (FileAlreadyExistsException e) {
                LOG.debug("{} is there already", opened.file);
            } catch (IOException e) {
                opened.fail("It could not be begun: " + sentence(e));
                return opened;
            }
        }
    }

    Recording recording() {
        return recording;
    }

    void append(RecordingChunk stretch) {
        TlogBuffer records = stretch.records();
        FileChannel to = channel;
        SentFrameIndex index = sent;
        if (to == null || index == null) {
            count(0, 0, records.frames());
            return;
        }
        try {
            records.writeTo(to);
            index.append(recording.bytes(), stretch.sent());
            lastMicros = Math.max(lastMicros, records.lastMicros());
            count(records.length(), records.frames(), 0);
        } catch (IOException e) {
            cutBack(to);
            count(0, 0, records.frames());
            fail("It could not be written on: " + sentence(e));
        }
    }

    void dropped(long frames) {
        if (frames > 0) {
            count(0, 0, frames);
        }
    }

    /** Writes no more; what still comes is counted as missing. */
    void fail(String why) {
        if (failure == null) {
            failure = why;
            count(0, 0, 0);
            LOG.warn("Recording {}: {}", recording.id(), why);
        }
        close();
    }

    /** The end; {@code notice} says what is missing at it, null: nothing. */
    Recording finish(@Nullable String notice) {
        close();
        String why = failure != null ? failure : notice;
        if (recording.drops() > 0) {
            String missing = recording.drops() + " messages are missing"
                    + (failure == null ? ", as the disk was too slow for them." : ".");
            why = why == null ? missing : why + " " + missing;
        }
        Recording r = recording;
        recording = new Recording(
                r.id(),
                r.drone(),
                r.droneName(),
                r.start(),
                lastMicros == 0 ? r.start() : instant(lastMicros),
                r.bytes(),
                r.frames(),
                r.drops(),
                why == null ? Recording.State.COMPLETE : Recording.State.INCOMPLETE,
                why);
        return recording;
    }

    private void count(long bytes, long frames, long drops) {
        Recording r = recording;
        recording = new Recording(
                r.id(),
                r.drone(),
                r.droneName(),
                r.start(),
                null,
                r.bytes() + bytes,
                r.frames() + frames,
                r.drops() + drops,
                Recording.State.RUNNING,
                failure);
    }

    /** No half record stays at the end. */
    private void cutBack(FileChannel to) {
        try {
            to.truncate(recording.bytes());
        } catch (IOException e) {
            LOG.warn("{} may end in the middle of a record", file, e);
        }
    }

    private void close() {
        try {
            if (channel != null) {
                channel.force(false);
                channel.close();
            }
            if (sent != null) {
                sent.close();
            }
        } catch (IOException e) {
            LOG.warn("{} was not closed cleanly", file, e);
        }
        channel = null;
        sent = null;
    }

    static Instant instant(long micros) {
        return Instant.EPOCH.plus(micros, ChronoUnit.MICROS);
    }

    private static String sentence(IOException e) {
        return e.getMessage() + ".";
    }
}
