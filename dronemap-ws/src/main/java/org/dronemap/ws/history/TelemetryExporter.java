package org.dronemap.ws.history;

import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.core.history.TrackWriter;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireTimes;
import org.dronemap.ws.recording.TlogExporter;
import org.dronemap.ws.track.TrackFormat;

/**
 * Writes stored telemetry of a drone or flight to a temporary file in the format that a client asked for. Any thread.
 */
public final class TelemetryExporter {
    private static final String PARQUET = "parquet";
    private static final int MOST_EVENTS = 5_000;
    private static final int MOST_POINTS = 100_000;

    private final TelemetryStore store;
    private final TlogExporter tlog;
    private final TrackWriter parquet;
    private final Path temporaryDirectory;

    /** A file that belongs to the caller from now on. */
    public record Export(Path file, String name, String mediaType) {}

    public TelemetryExporter(TelemetryStore store, TlogExporter tlog, TrackWriter parquet, Path temporaryDirectory) {
        this.store = store;
        this.tlog = tlog;
        this.parquet = parquet;
        this.temporaryDirectory = temporaryDirectory;
    }

    /** Whole before its first byte is handed out, so that a slow reader holds nothing up. */
    public Export export(TelemetryService.Subject subject, TelemetrySearchRequest search, String form)
            throws IOException {
        TimeRange span = subject.span(search);
        return switch (form) {
            case TlogExporter.FORM ->
                new Export(
                        made(form, path -> tlog.write(subject.drone(), span, path)),
                        name(subject, span, form),
                        "application/octet-stream");
            case PARQUET ->
                new Export(
                        made(form, path -> columns(subject.drone(), span, path)),
                        name(subject, span, form),
                        "application/vnd.apache.parquet");
            default -> text(subject, span, TrackFormat.named(form, List.of(PARQUET, TlogExporter.FORM)));
        };
    }

    private void columns(DroneId drone, TimeRange span, Path path) throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(path))) {
            parquet.write(points(drone, span), out);
        }
    }

    private Export text(TelemetryService.Subject subject, TimeRange span, TrackFormat kind) throws IOException {
        Path file = made(kind.ending(), path -> {
            try (BufferedWriter out = Files.newBufferedWriter(path)) {
                kind.write(track(subject, span, kind), out);
            }
        });
        return new Export(file, name(subject, span, kind.ending()), kind.mediaType());
    }

    private TrackFormat.Track track(TelemetryService.Subject subject, TimeRange span, TrackFormat kind) {
        return new TrackFormat.Track(
                subject.name(),
                points(subject.drone(), span),
                kind.hasEvents()
                        ? store.events(subject.drone(), span, MOST_EVENTS).stream()
                                .map(subject::shown)
                                .toList()
                        : List.of());
    }

    private interface ExportWriter {
        void into(Path file) throws IOException;
    }

    private Path made(String ending, ExportWriter making) throws IOException {
        Path file = Files.createTempFile(temporaryDirectory, "telemetry", "." + ending);
        try {
            making.into(file);
            return file;
        } catch (IOException | RuntimeException e) {
            Files.deleteIfExists(file);
            throw e;
        }
    }

    private static String name(TelemetryService.Subject subject, TimeRange span, String ending) {
        return subject.name().replaceAll("[^A-Za-z0-9-]+", "-") + "_"
                + WireTimes.shown(span.from()).toString().replaceAll("[^0-9TZ]", "") + "." + ending;
    }

    private List<TelemetryPoint> points(DroneId drone, TimeRange span) {
        List<TelemetryPoint> points = new ArrayList<>();
        store.points(drone, span, point -> {
            if (points.size() == MOST_POINTS) {
                throw new InvalidInput(
                        ValueProblem.EXPORT_TOO_LARGE,
                        "until",
                        "a time that leaves no more than " + MOST_POINTS + " points",
                        "That is more than " + MOST_POINTS + " points; ask for a shorter time.");
            }
            points.add(point);
        });
        return points;
    }
}
