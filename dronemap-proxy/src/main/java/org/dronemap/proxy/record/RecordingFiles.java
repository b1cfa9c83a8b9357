package org.dronemap.proxy.record;

import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.mavlink.tlog.TlogScan;

/** The directory of recordings: file names made of start time and drone, and repair of files that a crash cut off. */
record RecordingFiles(Path directory, String ending) {
    /** Of files with frames. */
    static final String FRAMES = ".tlog";
    /** Of files with a line of JSON for each message. */
    static final String LINES = ".jsonl";

    private static final String SENT_ENDING = ".sent.tsv";
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("yyyyMMdd'T'HHmmss'Z'").withZone(ZoneOffset.UTC);
    private static final Pattern ID = Pattern.compile("\\d{8}T\\d{6}Z_([a-z0-9-]{1,40})(_\\d+)?");

    RecordingFiles(Path directory) {
        this(directory, FRAMES);
    }

    /** New files end so. */
    RecordingFiles with(String newEnding) {
        return new RecordingFiles(directory, newEnding);
    }

    /** {@code number} tells those of the same second apart. */
    String id(Instant start, DroneId drone, int number) {
        return TIME.format(start) + "_" + drone.value() + (number == 1 ? "" : "_" + number);
    }

    /** The file of that recording, in whatever form it is. */
    Path path(String id) {
        Path lines = directory.resolve(id + LINES);
        return Files.exists(lines) ? lines : directory.resolve(id + FRAMES);
    }

    Path newPath(String id) {
        return directory.resolve(id + ending);
    }

    static boolean isOfFrames(Path file) {
        return file.toString().endsWith(FRAMES);
    }

    /** By what right each frame of it went out. */
    Path sentPath(String id) {
        return directory.resolve(id + SENT_ENDING);
    }

    /** Ids of all files here that bear the name of a recording. */
    List<String> ids() throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(FRAMES) || name.endsWith(LINES))
                    .map(name -> name.substring(0, name.lastIndexOf('.')))
                    .filter(id -> ID.matcher(id).matches())
                    .toList();
        }
    }

    Optional<DroneId> drone(String id) {
        Matcher parts = ID.matcher(id);
        return parts.matches() ? Optional.of(new DroneId(parts.group(1))) : Optional.empty();
    }

    private static TlogScan frames(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return TlogScan.of(in);
        }
    }

    /** Cuts half a record off the end, and tells what is left. */
    Recording repaired(Recording known, String notice) throws IOException {
        Path file = path(known.id());
        TlogScan scan = isOfFrames(file) ? frames(file) : LineRecordingScan.of(file);
        if (scan.wholeBytes() < Files.size(file)) {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
                channel.truncate(scan.wholeBytes());
            }
        }
        SentFrameIndex.repair(sentPath(known.id()), scan.wholeBytes());
        Instant start = scan.frames() == 0 ? known.start() : RecordingFileWriter.instant(scan.firstMicros());
        Instant end = scan.frames() == 0 ? known.start() : RecordingFileWriter.instant(scan.lastMicros());
        return new Recording(
                known.id(),
                known.drone(),
                known.droneName(),
                start,
                end,
                scan.wholeBytes(),
                scan.frames(),
                known.drops(),
                Recording.State.INCOMPLETE,
                notice);
    }
}
