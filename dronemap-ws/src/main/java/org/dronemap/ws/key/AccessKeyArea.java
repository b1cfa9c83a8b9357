package org.dronemap.ws.key;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.List;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.AreaReader;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.zone.ZoneGeometry;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** The area that flights commanded with an access key stay within, as a geometry of GeoJSON; one record for each type. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = AccessKeyArea.Polygon.class, name = "Polygon"),
    @JsonSubTypes.Type(value = AccessKeyArea.Point.class, name = "Point")
})
@Schema(name = "KeyArea", description = "An area as a geometry of GeoJSON: a Polygon, or a Point with a radius.")
public sealed interface AccessKeyArea {
    String FIELD = "area";

    /** Throws {@link InvalidInput} where a member cannot be used. */
    FenceArea shape();

    /** An area within corners. */
    @Schema(name = "PolygonKeyArea", description = "An area of 3 to 100 corners.")
    record Polygon(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description =
                            "One ring of positions, the last as the first; each longitude and latitude in degrees")
            @Nullable
            List<List<List<Double>>> coordinates)
            implements AccessKeyArea {
        @Override
        public FenceArea shape() {
            return reader().polygon(true, coordinates);
        }
    }

    /** A circle. */
    @Schema(name = "PointKeyArea", description = "A circle around a point.")
    record Point(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Longitude and latitude in degrees")
            @Nullable
            List<Double> coordinates,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres, 1 to 100000")
            @Min(FieldRanges.LEAST_RADIUS)
            @Max(FieldRanges.MOST_RADIUS)
            @Nullable
            Double radius)
            implements AccessKeyArea {
        @Override
        public FenceArea shape() {
            return reader().circle(true, coordinates, radius);
        }
    }

    private static AreaReader reader() {
        return new AreaReader(FIELD, FIELD + ".radius");
    }

    static @Nullable AccessKeyArea of(@Nullable FenceArea area) {
        if (area == null) {
            return null;
        }
        return area instanceof FenceArea.Circle circle
                ? new Point(ZoneGeometry.position(circle.center()), circle.radiusMeters())
                : new Polygon(ZoneGeometry.rings((FenceArea.Polygon) area));
    }

    /** "the circle of 500 m around 47.397700, 8.545600". */
    static String words(FenceArea area) {
        if (area instanceof FenceArea.Circle circle) {
            return "the circle of " + Math.round(circle.radiusMeters()) + " m around "
                    + circle.center().words();
        }
        List<String> corners = area instanceof FenceArea.Polygon polygon
                ? polygon.corners().stream()
                        .map(corner -> "(" + corner.words() + ")")
                        .toList()
                : List.of();
        return "the area with the corners " + String.join(" ", corners);
    }
}
