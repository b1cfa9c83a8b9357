package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.List;
import org.dronemap.core.mission.FenceZone;
import org.jspecify.annotations.Nullable;

/** The area that flights commanded with an access key stay within, as a geometry of GeoJSON. */
@Schema(name = "KeyArea")
public record KeyArea(
        @Schema(
                description = "Polygon: one ring; Point: the middle of a circle",
                allowableValues = {"Polygon", "Point"})
        @Nullable
        String type,

        @Schema(description = "Degrees, longitude first") @Nullable
        Object coordinates,

        @Schema(description = "Point: metres, 1 to 100000") @Min(Ranges.LEAST_RADIUS) @Max(Ranges.MOST_RADIUS) @Nullable
        Double radius) {
    static final String FIELD = "area";

    static @Nullable KeyArea of(@Nullable FenceZone area) {
        if (area == null) {
            return null;
        }
        ZoneFeature.ZoneGeometry geometry = ZoneFeature.geometry(area);
        return new KeyArea(
                geometry.type(),
                geometry.coordinates(),
                area instanceof FenceZone.Circle circle ? circle.radiusMeters() : null);
    }

    FenceZone shape() {
        return new AreaReader(FIELD, FIELD + ".radius")
                .shape(true, new ZoneFeature.ZoneGeometry(type, coordinates), radius);
    }

    /** "the circle of 500 m around 47.397700, 8.545600". */
    static String words(FenceZone area) {
        if (area instanceof FenceZone.Circle circle) {
            return "the circle of " + Math.round(circle.radiusMeters()) + " m around "
                    + circle.center().words();
        }
        List<String> corners = area instanceof FenceZone.Polygon polygon
                ? polygon.corners().stream()
                        .map(corner -> "(" + corner.words() + ")")
                        .toList()
                : List.of();
        return "the area with the corners " + String.join(" ", corners);
    }
}
