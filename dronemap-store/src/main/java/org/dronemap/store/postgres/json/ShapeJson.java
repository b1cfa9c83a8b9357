package org.dronemap.store.postgres.json;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.core.zone.AltitudeBand;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts areas and altitude bands to members of a JSON object and back, for the database. */
final class ShapeJson {
    private ShapeJson() {}

    static void write(FenceArea shape, ObjectNode to) {
        to.put("inside", shape.inside());
        if (shape instanceof FenceArea.Circle circle) {
            point(circle.center(), to.putObject("center"));
            to.put("radiusMeters", circle.radiusMeters());
        } else if (shape instanceof FenceArea.Polygon polygon) {
            ArrayNode corners = to.putArray("corners");
            polygon.corners().forEach(corner -> point(corner, corners.addObject()));
        }
    }

    static void write(AltitudeBand band, ObjectNode to) {
        to.put("floorMeters", band.floorMeters());
        to.put("ceilingMeters", band.ceilingMeters());
        to.put("altitudeReference", StoredNames.of(band.reference()));
    }

    private static void point(Geodetic point, ObjectNode to) {
        to.put("latitudeDegrees", point.latitudeDegrees());
        to.put("longitudeDegrees", point.longitudeDegrees());
    }

    static FenceArea shape(JsonNode from) {
        boolean inside = from.required("inside").booleanValue();
        if (from.has("center")) {
            return new FenceArea.Circle(
                    inside,
                    point(from.required("center")),
                    from.required("radiusMeters").doubleValue());
        }
        List<Geodetic> corners = new ArrayList<>();
        from.required("corners").forEach(corner -> corners.add(point(corner)));
        return new FenceArea.Polygon(inside, corners);
    }

    static AltitudeBand band(JsonNode from) {
        return new AltitudeBand(
                number(from, "floorMeters"),
                number(from, "ceilingMeters"),
                StoredNames.constant(
                        Altitude.Reference.class,
                        from.required("altitudeReference").stringValue()));
    }

    private static Geodetic point(JsonNode from) {
        return new Geodetic(
                from.required("latitudeDegrees").doubleValue(),
                from.required("longitudeDegrees").doubleValue());
    }

    private static @Nullable Double number(JsonNode from, String field) {
        return from.hasNonNull(field) ? Double.valueOf(from.required(field).doubleValue()) : null;
    }
}
