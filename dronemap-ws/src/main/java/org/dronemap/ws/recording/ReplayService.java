package org.dronemap.ws.recording;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Starts, lists and stops replays: recordings played back as drones that nobody can command. Any thread. */
public final class ReplayService {
    private static final int LEAST_SPEED = 1;
    private static final int MOST_SPEED = 100;

    private final ReplayGateway recordings;
    private final ReplayOwners owners;
    private final Path temporaryDirectory;

    public ReplayService(ReplayGateway recordings, ReplayOwners owners, Path temporaryDirectory) {
        this.recordings = recordings;
        this.owners = owners;
        this.temporaryDirectory = temporaryDirectory;
    }

    /** Keeps the whole recording in a file first, so that a slow upload does not slow the playing. */
    public ReplayView start(Principal principal, @Nullable String name, @Nullable Double speed, InputStream recording)
            throws IOException {
        RoleChecks.requireForAll(principal, Role.OPERATOR);
        String checked = NameRules.checked("name", name == null ? "recording.tlog" : name, 120);
        double times =
                FieldRanges.checked("speed", speed == null ? 1.0 : speed, LEAST_SPEED, MOST_SPEED, "times real time");
        Path file = Files.createTempFile(temporaryDirectory, "replay", ".tlog");
        try {
            try (OutputStream out = Files.newOutputStream(file)) {
                recording.transferTo(out);
            }
            long length = Files.size(file);
            if (length == 0) {
                throw new InvalidInput(
                        ValueProblem.FILE_UNUSABLE,
                        "body",
                        "the bytes of a recording (tlog)",
                        "The recording is empty.");
            }
            InputStream bytes = Files.newInputStream(file, StandardOpenOption.DELETE_ON_CLOSE);
            return play(principal, new Plan(checked, length, times), bytes);
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }

    /** Plays a file that stays where it is. */
    ReplayView play(Principal principal, String name, @Nullable Double speed, Path file) throws IOException {
        RoleChecks.requireForAll(principal, Role.OPERATOR);
        double times =
                FieldRanges.checked("speed", speed == null ? 1.0 : speed, LEAST_SPEED, MOST_SPEED, "times real time");
        return play(principal, new Plan(name, Files.size(file), times), Files.newInputStream(file));
    }

    private record Plan(String name, long lengthBytes, double speed) {}

    private ReplayView play(Principal principal, Plan plan, InputStream bytes) throws IOException {
        try {
            ReplayView view = recordings.start(plan.name(), bytes, plan.lengthBytes(), plan.speed());
            owners.began(view.id(), principal.organisation());
            return view;
        } catch (IllegalStateException tooMany) {
            bytes.close();
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    String.valueOf(tooMany.getMessage()),
                    ProblemParameter.WHAT.is("replays"));
        }
    }

    public List<ReplayView> replays(Principal principal) {
        RoleChecks.requireForAll(principal, Role.VIEWER);
        return recordings.all().stream()
                .filter(replay -> owners.isOf(replay.id(), principal.organisation()))
                .toList();
    }

    public ReplayView replay(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.VIEWER);
        return recordings
                .find(id)
                .filter(replay -> owners.isOf(id, principal.organisation()))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.REPLAY, id));
    }

    public void remove(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.OPERATOR);
        if (!owners.isOf(id, principal.organisation()) || !recordings.remove(id)) {
            throw Rejection.unknown(NotFoundProblem.REPLAY, id);
        }
    }
}
