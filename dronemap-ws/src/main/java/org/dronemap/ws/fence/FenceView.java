package org.dronemap.ws.fence;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** The geofence on board of a vehicle, which clients read and write in the same form; null zones: not read yet. */
@Schema(name = "FenceView")
public record FenceView(@Nullable List<ZoneView> zones) {
    /** An area that the vehicle stays in or out of; one record for each type. */
    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes({
        @JsonSubTypes.Type(value = PolygonView.class, name = "polygon"),
        @JsonSubTypes.Type(value = CircleView.class, name = "circle")
    })
    @Schema(
            name = "FenceZoneView",
            description = "An area that the vehicle stays in or out of; which members there are depends on the type.")
    public sealed interface ZoneView {
        /**
         * Throws {@link InvalidInput} where a member cannot be used.
         *
         * @param at what stands before its members' names, such as {@code zones[2].}
         */
        FenceArea read(String at);
    }

    /** An area within corners. */
    @Schema(name = "FencePolygonView", description = "An area within corners.")
    public record PolygonView(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Whether it stays in it, or out of it")
            @Nullable
            Boolean inside,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "3 to 100")
            @Size(min = FenceReader.LEAST_CORNERS, max = FenceReader.MOST_CORNERS)
            @Nullable
            List<FencePointView> corners)
            implements ZoneView {
        @Override
        public FenceArea read(String at) {
            return new FenceArea.Polygon(FenceReader.inside(at, inside), FenceReader.corners(at, corners));
        }
    }

    /** An area round a point. */
    @Schema(name = "FenceCircleView", description = "An area round a point.")
    public record CircleView(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Whether it stays in it, or out of it")
            @Nullable
            Boolean inside,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            FencePointView center,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres, 1 to 100000")
            @Min(FieldRanges.LEAST_RADIUS)
            @Max(FieldRanges.MOST_RADIUS)
            @Nullable
            Double radius)
            implements ZoneView {
        @Override
        public FenceArea read(String at) {
            return new FenceArea.Circle(
                    FenceReader.inside(at, inside),
                    FenceReader.point(at + "center.", center),
                    FieldRanges.radius(at + "radius", radius));
        }
    }

    /** Degrees. */
    @Schema(name = "FencePointView")
    public record FencePointView(
            @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude) {
        static FencePointView of(Geodetic point) {
            return new FencePointView(point.latitudeDegrees(), point.longitudeDegrees());
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
            @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Nullable Double altitude) {}

    static FenceView of(@Nullable List<FenceArea> zones) {
        return new FenceView(
                zones == null ? null : zones.stream().map(FenceView::zone).toList());
    }

    private static ZoneView zone(FenceArea zone) {
        return zone instanceof FenceArea.Circle circle
                ? new CircleView(circle.inside(), FencePointView.of(circle.center()), circle.radiusMeters())
                : polygon((FenceArea.Polygon) zone);
    }

    private static ZoneView polygon(FenceArea.Polygon polygon) {
        return new PolygonView(
                polygon.inside(),
                polygon.corners().stream().map(FencePointView::of).toList());
    }
}
