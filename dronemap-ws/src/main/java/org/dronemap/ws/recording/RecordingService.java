package org.dronemap.ws.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Lists, downloads, replays and deletes recordings of flights (the messages exchanged with a vehicle), for users. Any
 * thread.
 */
public final class RecordingService {
    /** How files with a line of JSON for each message end; others hold frames. */
    public static final String LINES = ".jsonl";

    private static final String FRAMES = ".tlog";

    private final RecordingArchive archive;
    private final ReplayService replays;

    /** The bytes of a recording under a name that says whose it is. */
    public record Download(Path file, String name) {}

    public RecordingService(RecordingArchive archive, ReplayService replays) {
        this.archive = archive;
        this.replays = replays;
    }

    /** Newest first; {@code drone} null: of all drones. */
    public RecordingView.Page recordings(Principal principal, @Nullable String drone) {
        List<RecordingView> views = archive.recordings().stream()
                .filter(recording -> isShown(principal, recording))
                .filter(recording -> drone == null || recording.drone().value().equals(drone))
                .map(RecordingView::of)
                .toList();
        return new RecordingView.Page(views, room(principal));
    }

    private static boolean isShown(Principal principal, Recording recording) {
        return principal.sight(recording.drone(), recording.start()) != VisibilityLevel.NONE;
    }

    /** Who does not see all that may be in it is told of the own part alone. */
    private RecordingView.RoomView room(Principal principal) {
        RecordingArchive.DiskUsage room = archive.room();
        if (principal.isWhole() && principal.organisation().isHome()) {
            return RecordingView.RoomView.of(room);
        }
        long own = archive.recordings().stream()
                .filter(recording -> isShown(principal, recording))
                .mapToLong(Recording::bytes)
                .sum();
        return RecordingView.RoomView.of(
                new RecordingArchive.DiskUsage(own, room.mostBytes(), room.keepDays(), 0, null));
    }

    public RecordingView recording(Principal principal, String id) {
        return RecordingView.of(find(principal, id));
    }

    public Download download(Principal principal, String id) throws IOException {
        Recording recording = find(principal, id);
        Path file = file(id);
        return new Download(file, name(recording) + (isLines(file) ? LINES : FRAMES));
    }

    /** Who sent what: a line for each frame that went out. */
    public Download sent(Principal principal, String id) throws IOException {
        Recording recording = find(principal, id);
        if (principal.sight(recording.drone(), recording.start()) != VisibilityLevel.ALL) {
            throw Rejection.of(
                    DroneProblem.OF_ANOTHER_ORGANISATION,
                    "The drone was another organisation's then; only that one sees who sent what.");
        }
        String name = name(recording) + ".sent.tsv";
        return new Download(
                archive.sent(id)
                        .orElseThrow(() -> Rejection.of(
                                DroneProblem.SENDERS_NOT_RECORDED,
                                "Recording " + id + " was made before it was noted who sent what.",
                                ProblemParameter.ID.is(id))),
                name);
    }

    private static String name(Recording recording) {
        return recording.droneName().replaceAll("[^A-Za-z0-9-]+", "-") + "_" + recording.id();
    }

    /** Deleting is for ever, so it wants to be said twice. */
    public void delete(Principal principal, String id, boolean confirmed) throws IOException {
        Recording recording = find(principal, id, Role.OPERATOR);
        if (principal.sight(recording.drone(), recording.start()) != VisibilityLevel.ALL) {
            throw Rejection.of(
                    DroneProblem.OF_ANOTHER_ORGANISATION,
                    "The drone was another organisation's then; only the server's rules remove it.");
        }
        if (!confirmed) {
            throw new InvalidInput(
                    ValueProblem.CONFIRMATION_MISSING,
                    "confirm",
                    "true",
                    "A deleted recording cannot be brought back; say confirm=true if that is meant.");
        }
        Optional<String> refusal = archive.delete(id);
        if (refusal.isPresent()) {
            throw archive.recording(id).isEmpty()
                    ? Rejection.unknown(NotFoundProblem.RECORDING, id)
                    : Rejection.of(DroneProblem.RECORDING_GOES_ON, refusal.get(), ProblemParameter.ID.is(id));
        }
    }

    public ReplayView replay(Principal principal, String id, @Nullable Double speed) throws IOException {
        Recording recording = find(principal, id, Role.OPERATOR);
        Path file = file(id);
        if (isLines(file)) {
            throw Rejection.of(
                    DroneProblem.RECORDING_NOT_PLAYABLE,
                    "This recording holds texts and cannot be played on the map; download it instead.",
                    ProblemParameter.ID.is(id));
        }
        return replays.play(principal, recording.id() + FRAMES, speed, file);
    }

    private static boolean isLines(Path file) {
        return file.toString().endsWith(LINES);
    }

    private Recording find(Principal principal, String id, Role needed) {
        RoleChecks.require(principal, needed);
        Recording recording = find(principal, id);
        RoleChecks.require(principal, needed, recording.drone());
        return recording;
    }

    private Recording find(Principal principal, String id) {
        return archive.recording(id)
                .filter(recording -> isShown(principal, recording))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.RECORDING, id));
    }

    private Path file(String id) throws IOException {
        return archive.file(id)
                .orElseThrow(() -> Rejection.of(
                        DroneProblem.RECORDING_FILE_GONE,
                        "The file of recording " + id + " is not there any more.",
                        ProblemParameter.ID.is(id)));
    }
}
