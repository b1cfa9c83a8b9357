package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.RallyPoint;
import org.jspecify.annotations.Nullable;

/** The fence on board of a vehicle, read and written in the same form; {@code zones} is null until it was read. */
@Schema(name = "FenceView")
public record FenceView(@Nullable List<ZoneView> zones) {
    /** {@code type} is polygon (with corners) or circle (with center and radius in metres). */
    @Schema(name = "FenceZoneView")
    public record ZoneView(
            @Schema(allowableValues = {"polygon", "circle"}) @Nullable
            String type,

            @Nullable Boolean inside,

            @Size(min = FenceReader.LEAST_CORNERS, max = FenceReader.MOST_CORNERS) @Nullable
            List<PointView> corners,

            @Nullable PointView center,

            @Min(Ranges.LEAST_RADIUS) @Max(Ranges.MOST_RADIUS) @Nullable
            Double radius) {}

    /** Degrees. */
    @Schema(name = "FencePointView")
    public record PointView(
            @Min(-Ranges.LATITUDE) @Max(Ranges.LATITUDE) @Nullable
            Double latitude,

            @Min(-Ranges.LONGITUDE) @Max(Ranges.LONGITUDE) @Nullable
            Double longitude) {
        static PointView of(Geodetic point) {
            return new PointView(point.latitudeDegrees(), point.longitudeDegrees());
        }
    }

    /** Rally points; null until they were read. */
    @Schema(name = "FenceRallyView")
    public record RallyView(@Nullable List<RallyPointView> points) {
        static RallyView of(@Nullable List<RallyPoint> points) {
            return new RallyView(
                    points == null
                            ? null
                            : points.stream()
                                    .map(point -> new RallyPointView(
                                            point.point().latitudeDegrees(),
                                            point.point().longitudeDegrees(),
                                            point.altitudeMeters()))
                                    .toList());
        }
    }

    /** The altitude is above home, in metres. */
    @Schema(name = "FenceRallyPointView")
    public record RallyPointView(
            @Min(-Ranges.LATITUDE) @Max(Ranges.LATITUDE) @Nullable
            Double latitude,

            @Min(-Ranges.LONGITUDE) @Max(Ranges.LONGITUDE) @Nullable
            Double longitude,

            @Nullable Double altitude) {}

    static FenceView of(@Nullable List<FenceZone> zones) {
        return new FenceView(
                zones == null ? null : zones.stream().map(FenceView::zone).toList());
    }

    private static ZoneView zone(FenceZone zone) {
        if (zone instanceof FenceZone.Circle circle) {
            return new ZoneView("circle", circle.inside(), null, PointView.of(circle.center()), circle.radiusMeters());
        }
        List<PointView> corners = zone instanceof FenceZone.Polygon polygon
                ? polygon.corners().stream().map(PointView::of).toList()
                : List.of();
        return new ZoneView("polygon", zone.inside(), corners, null, null);
    }
}
