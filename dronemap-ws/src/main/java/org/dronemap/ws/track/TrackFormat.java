package org.dronemap.ws.track;

import java.io.IOException;
import java.io.Writer;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireNames;

/** Text formats in which the recorded track of a drone or flight is exported: CSV, GeoJSON, KML and GPX. */
public enum TrackFormat {
    /** All numbers, for spreadsheets. */
    CSV("text/csv;charset=UTF-8", false) {
        @Override
        public void write(Track track, Writer out) throws IOException {
            CsvTrackWriter.write(track, out);
        }
    },
    GEOJSON("application/geo+json", true) {
        @Override
        public void write(Track track, Writer out) throws IOException {
            GeoJsonTrackWriter.write(track, out);
        }
    },
    KML("application/vnd.google-earth.kml+xml", true) {
        @Override
        public void write(Track track, Writer out) throws IOException {
            XmlTrackWriter.kml(track, out);
        }
    },
    GPX("application/gpx+xml", false) {
        @Override
        public void write(Track track, Writer out) throws IOException {
            XmlTrackWriter.gpx(track, out);
        }
    };

    private final String mediaType;
    private final boolean hasEvents;

    /** Points in the order of time. */
    public record Track(String name, List<TelemetryPoint> points, List<HistoryEvent> events) {}

    TrackFormat(String mediaType, boolean hasEvents) {
        this.mediaType = mediaType;
        this.hasEvents = hasEvents;
    }

    /** {@code others}: forms that are made in another way, for the sentence of a refusal. */
    public static TrackFormat named(String form, List<String> others) {
        return Arrays.stream(values())
                .filter(one -> one.ending().equals(form))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED,
                        "form",
                        Stream.concat(Arrays.stream(values()).map(TrackFormat::ending), others.stream())
                                .collect(Collectors.joining(", ")),
                        "\"" + form + "\""));
    }

    /** Of a file's name. */
    public String ending() {
        return WireNames.camel(this);
    }

    public String mediaType() {
        return mediaType;
    }

    /** What happened stands in it, too. */
    public boolean hasEvents() {
        return hasEvents;
    }

    public abstract void write(Track track, Writer out) throws IOException;
}
