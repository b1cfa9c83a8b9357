package org.dronemap.ws.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.TimeRange;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingArchive;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;

/** Writes the messages of a time span as a tlog, joined from the recordings of that drone. Any thread. */
public final class TlogExporter {
    public static final String FORM = "tlog";
    private static final long MOST_BYTES = 512_000_000;

    private final RecordingArchive recordings;

    public TlogExporter(RecordingArchive recordings) {
        this.recordings = recordings;
    }

    /** Refused where there is no recording of that time. */
    public void write(DroneId drone, TimeRange span, Path file) throws IOException {
        List<Recording> parts = recordings.recordings().stream()
                .filter(recording -> recording.drone().equals(drone) && overlaps(recording, span))
                .sorted(Comparator.comparing(Recording::start))
                .toList();
        if (parts.stream().mapToLong(Recording::bytes).sum() > MOST_BYTES) {
            throw new InvalidInput(
                    ValueProblem.EXPORT_TOO_LARGE,
                    "until",
                    "a time with no more than 512 MB of recordings",
                    "The recordings of that time have more than 512 MB; ask for a shorter time, or for them one by one.");
        }
        long messages = 0;
        try (OutputStream out = Files.newOutputStream(file)) {
            for (Recording part : parts) {
                messages += recordings.cut(part.id(), span.from(), span.until(), out);
            }
        }
        if (messages == 0) {
            throw Rejection.of(
                    DroneProblem.NO_RECORDING_THEN,
                    "There is no recording of that drone at that time, so there is no tlog; the other"
                            + " forms are made of what was kept of its state.",
                    ProblemParameter.DRONE.is(drone.value()));
        }
    }

    private static boolean overlaps(Recording recording, TimeRange span) {
        Instant end = recording.end();
        return recording.start().isBefore(span.until()) && (end == null || !end.isBefore(span.from()));
    }
}
