package org.dronemap.ws.service;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/** Use cases around recordings played back. Any thread. */
public final class ReplayService {
    private static final int LEAST_SPEED = 1;
    private static final int MOST_SPEED = 100;

    private final Recordings recordings;
    private final Path temporaryDirectory;

    public ReplayService(Recordings recordings, Path temporaryDirectory) {
        this.recordings = recordings;
        this.temporaryDirectory = temporaryDirectory;
    }

    /** Keeps the whole recording in a file first, so that a slow upload does not slow the playing. */
    public ReplayView start(Principal principal, @Nullable String name, @Nullable Double speed, InputStream recording)
            throws IOException {
        Roles.requireForAll(principal, Role.OPERATOR);
        String checked = Names.checked("name", name == null ? "recording.tlog" : name, 120);
        double times = Ranges.checked("speed", speed == null ? 1.0 : speed, LEAST_SPEED, MOST_SPEED, "times real time");
        Path file = Files.createTempFile(temporaryDirectory, "replay", ".tlog");
        try {
            try (OutputStream out = Files.newOutputStream(file)) {
                recording.transferTo(out);
            }
            long length = Files.size(file);
            if (length == 0) {
                throw new InvalidInput("body", "the bytes of a recording (tlog)", "The recording is empty.");
            }
            return play(checked, Files.newInputStream(file, StandardOpenOption.DELETE_ON_CLOSE), length, times);
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }

    /** Plays a file that stays where it is. */
    ReplayView play(Principal principal, String name, @Nullable Double speed, Path file) throws IOException {
        Roles.requireForAll(principal, Role.OPERATOR);
        double times = Ranges.checked("speed", speed == null ? 1.0 : speed, LEAST_SPEED, MOST_SPEED, "times real time");
        return play(name, Files.newInputStream(file), Files.size(file), times);
    }

    private ReplayView play(String name, InputStream bytes, long length, double speed) throws IOException {
        try {
            return recordings.start(name, bytes, length, speed);
        } catch (IllegalStateException tooMany) {
            bytes.close();
            throw Rejection.conflict(String.valueOf(tooMany.getMessage()));
        }
    }

    public List<ReplayView> replays(Principal principal) {
        Roles.requireForAll(principal, Role.VIEWER);
        return recordings.all();
    }

    public ReplayView replay(Principal principal, String id) {
        Roles.requireForAll(principal, Role.VIEWER);
        return recordings.find(id).orElseThrow(() -> Rejection.unknown("replay", id));
    }

    public void remove(Principal principal, String id) {
        Roles.requireForAll(principal, Role.OPERATOR);
        if (!recordings.remove(id)) {
            throw Rejection.unknown("replay", id);
        }
    }
}
