package org.dronemap.ws.log;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;

/**
 * Stores log files that were downloaded from vehicles on the server's disk, in a folder for each drone. Any thread; one
 * thread of its own writes.
 */
public final class OnboardLogArchive implements AutoCloseable {
    private static final int MOST_WAITING = 4_096;
    private static final long ROOM_TO_LEAVE_BYTES = 200L * 1024 * 1024;
    private static final Duration LONGEST_CLOSING = Duration.ofSeconds(5);

    private final Path folder;
    private final Worker writer;

    public OnboardLogArchive(Path folder, Time time) {
        this.folder = folder;
        this.writer = time.worker("log-writer", MOST_WAITING);
    }

    /** Opens a log for writing; what an earlier attempt left is kept. */
    OnboardLogFile open(DroneId drone, VehicleLog log) {
        try {
            Files.createDirectories(folder.resolve(drone.value()));
            if (folder.toFile().getUsableSpace() < log.sizeBytes() + ROOM_TO_LEAVE_BYTES) {
                throw Rejection.of(
                        ServerProblem.DISK_FULL, "There is no room on the server's disk for a log of this size.");
            }
            return new OnboardLogFile(stem(drone, log), log, writer);
        } catch (IOException e) {
            throw new UncheckedIOException("a log cannot be written under " + folder, e);
        }
    }

    /** The whole log, once it is there. */
    Optional<Path> find(DroneId drone, VehicleLog log) {
        Path file = OnboardLogFile.whole(stem(drone, log));
        return Files.isRegularFile(file) ? Optional.of(file) : Optional.empty();
    }

    /** Takes the file and what is left of attempts away; false when there was nothing. */
    boolean remove(DroneId drone, VehicleLog log) {
        try {
            Path stem = stem(drone, log);
            boolean whole = Files.deleteIfExists(OnboardLogFile.whole(stem));
            boolean part = Files.deleteIfExists(OnboardLogFile.part(stem));
            return Files.deleteIfExists(OnboardLogFile.kept(stem)) || part || whole;
        } catch (IOException e) {
            throw new UncheckedIOException("a log cannot be removed under " + folder, e);
        }
    }

    /** Logs of one number are told apart by time and size, should the vehicle count anew. */
    private Path stem(DroneId drone, VehicleLog log) {
        long second = log.at() == null ? 0 : log.at().getEpochSecond();
        return folder.resolve(drone.value())
                .resolve(String.format(Locale.ROOT, "%d-%d-%d", log.number(), second, log.sizeBytes()));
    }

    @Override
    public void close() {
        writer.finish(LONGEST_CLOSING);
    }
}
