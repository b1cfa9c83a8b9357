package org.dronemap.ws.track;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.ws.reading.PositionedPoints;
import org.dronemap.ws.reading.WireNames;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.json.JsonMapper;

/** Writes a drone's recorded track as GeoJSON: a line with times, and a point for each event. */
final class GeoJsonTrackWriter {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    private GeoJsonTrackWriter() {}

    static void write(TrackFormat.Track track, Writer out) throws IOException {
        List<TelemetryPoint> placed = PositionedPoints.of(track.points());
        try (JsonGenerator json = MAPPER.createGenerator(out)) {
            json.writeStartObject();
            json.writeStringProperty("type", "FeatureCollection");
            json.writeArrayPropertyStart("features");
            if (placed.size() > 1) {
                line(track.name(), placed, json);
            }
            for (HistoryEvent event : track.events()) {
                PositionedPoints.at(placed, event.at()).ifPresent(point -> event(event, point, json));
            }
            json.writeEndArray();
            json.writeEndObject();
        }
    }

    private static void line(String name, List<TelemetryPoint> placed, JsonGenerator json) {
        json.writeStartObject();
        json.writeStringProperty("type", "Feature");
        json.writeObjectPropertyStart("geometry");
        json.writeStringProperty("type", "LineString");
        json.writeArrayPropertyStart("coordinates");
        placed.forEach(point -> coordinates(point, json));
        json.writeEndArray();
        json.writeEndObject();
        json.writeObjectPropertyStart("properties");
        json.writeStringProperty("name", name);
        json.writeArrayPropertyStart("coordTimes");
        placed.forEach(point -> json.writeString(point.at().toString()));
        json.writeEndArray();
        json.writeEndObject();
        json.writeEndObject();
    }

    private static void event(HistoryEvent event, TelemetryPoint where, JsonGenerator json) {
        json.writeStartObject();
        json.writeStringProperty("type", "Feature");
        json.writeObjectPropertyStart("geometry");
        json.writeStringProperty("type", "Point");
        json.writeName("coordinates");
        coordinates(where, json);
        json.writeEndObject();
        json.writeObjectPropertyStart("properties");
        json.writeStringProperty("name", event.text());
        json.writeStringProperty("kind", WireNames.camel(event.kind()));
        json.writeStringProperty("at", event.at().toString());
        if (event.by() != null) {
            json.writeStringProperty("by", event.by());
        }
        if (event.result() != null) {
            json.writeStringProperty("result", event.result());
        }
        json.writeEndObject();
        json.writeEndObject();
    }

    private static void coordinates(TelemetryPoint point, JsonGenerator json) {
        Geodetic place = PositionedPoints.place(point);
        Position position = point.position();
        Double altitude = position == null ? null : position.altitudeAmslMeters();
        json.writeStartArray();
        json.writeNumber(place.longitudeDegrees());
        json.writeNumber(place.latitudeDegrees());
        if (altitude != null) {
            json.writeNumber(altitude);
        }
        json.writeEndArray();
    }
}
