package org.dronemap.ws.zone;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.AreaReader;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** The GeoJSON geometry of a zone: a polygon, or a point with a radius. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = ZoneGeometry.Polygon.class, name = "Polygon"),
    @JsonSubTypes.Type(value = ZoneGeometry.Point.class, name = "Point")
})
@Schema(name = "ZoneGeometry", description = "A geometry of GeoJSON.")
public sealed interface ZoneGeometry {
    /** Throws {@link InvalidInput} where the coordinates cannot be used; {@code radius}: of a circle, in metres. */
    FenceArea shape(AreaReader reader, boolean inside, @Nullable Double radius);

    /** An area within corners. */
    @Schema(name = "PolygonGeometry", description = "An area of 3 to 1000 corners.")
    record Polygon(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description =
                            "One ring of positions, the last as the first; each longitude and latitude in degrees")
            @Nullable
            List<List<List<Double>>> coordinates)
            implements ZoneGeometry {
        @Override
        public FenceArea shape(AreaReader reader, boolean inside, @Nullable Double radius) {
            return reader.polygon(inside, coordinates);
        }
    }

    /** The middle of a circle. */
    @Schema(name = "PointGeometry", description = "The middle of a circle.")
    record Point(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Longitude and latitude in degrees")
            @Nullable
            List<Double> coordinates)
            implements ZoneGeometry {
        @Override
        public FenceArea shape(AreaReader reader, boolean inside, @Nullable Double radius) {
            return reader.circle(inside, coordinates, radius);
        }
    }

    static ZoneGeometry of(FenceArea shape) {
        return shape instanceof FenceArea.Circle circle
                ? new Point(position(circle.center()))
                : new Polygon(rings((FenceArea.Polygon) shape));
    }

    /** One, which ends where it began. */
    static List<List<List<Double>>> rings(FenceArea.Polygon polygon) {
        List<List<Double>> ring = new ArrayList<>();
        polygon.corners().forEach(corner -> ring.add(position(corner)));
        ring.add(ring.get(0));
        return List.of(ring);
    }

    static List<Double> position(Geodetic point) {
        return List.of(point.longitudeDegrees(), point.latitudeDegrees());
    }
}
