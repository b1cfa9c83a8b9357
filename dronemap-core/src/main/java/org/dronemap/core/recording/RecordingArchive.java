package org.dronemap.core.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Access to the recordings of this server, metadata and files. Any thread; blocks for the disk and the store. */
public interface RecordingArchive {
    /** All of them, newest start first; those that go on with their counts of now. */
    List<Recording> recordings();

    Optional<Recording> recording(String id);

    /** The file as it is now, all that was heard so far in it; empty when there is none. */
    Optional<Path> file(String id) throws IOException;

    /**
     * By what right each frame in it went out, as tab-separated lines: place in the file (bytes), command, epoch of
     * control, user. Empty when there is none.
     */
    Optional<Path> sent(String id) throws IOException;

    /**
     * Writes those messages of one recording that were heard or sent at {@code from} or later and before {@code until},
     * in the form of the file. Returns how many; none when there is no such file.
     */
    long cut(String id, Instant from, Instant until, OutputStream out) throws IOException;

    /** Refused with a sentence while it goes on or when there is none; empty when it is gone. */
    Optional<String> delete(String id) throws IOException;

    /** What is heard of that drone from now on is another recording; returns once the one of before has ended. */
    void part(DroneId drone) throws IOException;

    DiskUsage room();

    /**
     * Disk space and retention of the recordings: present use and limits.
     *
     * @param keepDays 0: for ever
     * @param removed how many were removed since the start to keep within this
     * @param notice the sentence about the last removal or failure; null when there was none
     */
    record DiskUsage(
            long usedBytes,
            long mostBytes,
            int keepDays,
            long removed,
            @Nullable String notice) {}
}
