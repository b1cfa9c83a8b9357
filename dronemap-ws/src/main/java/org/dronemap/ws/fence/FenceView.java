package org.dronemap.ws.fence;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.DecimalMin;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/**
 * The geofence on board of a vehicle, which clients read and write in the same form; null zones: not read yet.
 *
 * @param leftOut what the vehicle has beside it and cannot be told, each as a sentence; a fence with any is not written
 */
@Schema(name = "FenceView")
public record FenceView(
        @Nullable List<ZoneView> zones,

        @Schema(description = "Where the fence sends the vehicle after a breach; null: nowhere of its own") @Nullable
        ReturnPointView returnPoint,

        @Schema(
                description =
                        "What the vehicle has beside it and cannot be told, each as a sentence; a fence that was read"
                                + " with such cannot be written back")
        @Nullable
        List<String> leftOut) {
    /** The place that a fence sends a vehicle to after a breach. */
    @Schema(name = "FenceReturnPointView")
    public record ReturnPointView(
            @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "Metres from what altitudeReference says; null: the vehicle keeps none (ArduPilot)")
            @Nullable
            Double altitude,

            @Schema(description = "What the altitude is measured from: home (the default), amsl or terrain")
            @EnumValues(HeightReference.class)
            @Nullable
            String altitudeReference) {
        static ReturnPointView of(FenceReturnPoint point) {
            return new ReturnPointView(
                    point.point().latitudeDegrees(),
                    point.point().longitudeDegrees(),
                    point.hasHeight() ? Double.valueOf(point.altitudeMeters()) : null,
                    point.hasHeight() ? WireNames.camel(point.reference()) : null);
        }
    }

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

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "3 to 1000")
            @Size(min = FenceArea.Polygon.LEAST_CORNERS, max = FenceArea.Polygon.MOST_CORNERS)
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

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres, 0.01 to 100000")
            @DecimalMin("0.01")
            @Max(FieldRanges.MOST_RADIUS)
            @Nullable
            Double radius)
            implements ZoneView {
        @Override
        public FenceArea read(String at) {
            return new FenceArea.Circle(
                    FenceReader.inside(at, inside),
                    FenceReader.point(at + "center.", center),
                    FieldRanges.fenceRadius(at + "radius", radius));
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
    public record RallyView(
            @Nullable List<RallyPointView> points,

            @Schema(
                    description =
                            "What the vehicle has beside them and cannot be told, each as a sentence; points that were"
                                    + " read with such cannot be written back")
            @Nullable
            List<String> leftOut) {
        static RallyView of(@Nullable OnboardRallyPoints read) {
            return read == null
                    ? new RallyView(null, null)
                    : new RallyView(
                            read.points().stream().map(RallyPointView::of).toList(), read.leftOut());
        }
    }

    /** A place to return to instead of home. */
    @Schema(name = "FenceRallyPointView")
    public record RallyPointView(
            @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "Metres from what altitudeReference says")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(
                    description =
                            "What the altitude is measured from: home (the default), amsl, or terrain: the ground below,"
                                    + " as the vehicle's own map has it")
            @EnumValues(HeightReference.class)
            @Nullable
            String altitudeReference) {
        static RallyPointView of(RallyPoint point) {
            return new RallyPointView(
                    point.point().latitudeDegrees(),
                    point.point().longitudeDegrees(),
                    point.altitudeMeters(),
                    WireNames.camel(point.reference()));
        }
    }

    static FenceView of(@Nullable OnboardFence read) {
        if (read == null) {
            return new FenceView(null, null, null);
        }
        FenceReturnPoint back = read.returnPoint();
        return new FenceView(
                read.areas().stream().map(FenceView::zone).toList(),
                back == null ? null : ReturnPointView.of(back),
                read.leftOut());
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
