package org.dronemap.ws.track;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.ws.reading.Csv;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Writes a drone's recorded track as CSV: one line for each point, one column for each field. */
final class CsvTrackWriter {
    private CsvTrackWriter() {}

    static void write(TrackFormat.Track track, Writer out) throws IOException {
        List<String> header = new ArrayList<>(List.of("at"));
        for (TelemetryField field : TelemetryField.values()) {
            header.add(WireNames.camel(field));
        }
        header.addAll(List.of("gpsFix", "mode", "armed", "flight", "link"));
        out.write(Csv.line(header));
        for (TelemetryPoint point : track.points()) {
            out.write(row(point));
        }
    }

    private static String row(TelemetryPoint point) {
        List<@Nullable Object> cells = new ArrayList<>();
        cells.add(point.at());
        for (TelemetryField field : TelemetryField.values()) {
            cells.add(field.of(point));
        }
        GpsFix fix = point.gps() == null ? null : point.gps().fix();
        cells.add(fix == null ? null : fix.label());
        cells.add(point.mode());
        cells.add(point.armed());
        cells.add(point.phase() == null ? null : WireNames.camel(point.phase()));
        cells.add(WireNames.camel(point.link()));
        return Csv.line(cells);
    }
}
