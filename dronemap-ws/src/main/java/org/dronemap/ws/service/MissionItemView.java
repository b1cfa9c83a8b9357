package org.dronemap.ws.service;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** One step of a mission as clients read and write it; which members are there depends on the type. */
@JsonInclude(JsonInclude.Include.NON_NULL)
@Schema(name = "MissionItemView", description = "One step of a mission; which members are there depends on the type.")
public record MissionItemView(
        @Schema(description = "other: read only") @ValuesOf(MissionItem.Kind.class) @Nullable
        String type,

        @Schema(description = "waypoint, lookAt: degrees") @Min(-Ranges.LATITUDE) @Max(Ranges.LATITUDE) @Nullable
        Double latitude,

        @Schema(description = "waypoint, lookAt: degrees") @Min(-Ranges.LONGITUDE) @Max(Ranges.LONGITUDE) @Nullable
        Double longitude,

        @Schema(description = "takeOff, waypoint, lookAt: metres") @Nullable
        Double altitude,

        @Schema(description = "waypoint, lookAt: home (the default) or amsl")
        @ValuesOf(Altitude.Reference.class)
        @Nullable
        String altitudeReference,

        @Schema(description = "waypoint, wait: seconds to wait there") @Nullable
        Double holdSeconds,

        @Schema(description = "setServo: which output, 1 to 32") @Nullable
        Integer output,

        @Schema(description = "setServo: length of its pulses in microseconds, 500 to 2500") @Nullable
        Integer pulse,

        @Schema(description = "other: what it is") @Nullable String description) {
    private static MissionItemView plain(String type, @Nullable Double altitude, @Nullable Double holdSeconds) {
        return new MissionItemView(type, null, null, altitude, null, holdSeconds, null, null, null);
    }

    private static MissionItemView placed(
            String type, Geodetic point, Altitude altitude, @Nullable Double holdSeconds) {
        return new MissionItemView(
                type,
                point.latitudeDegrees(),
                point.longitudeDegrees(),
                altitude.meters(),
                WireNames.camel(altitude.reference()),
                holdSeconds,
                null,
                null,
                null);
    }

    public static MissionItemView of(MissionItem item) {
        String type = item.kind().word();
        return switch (item.kind()) {
            case TAKE_OFF -> plain(type, ((MissionItem.TakeOff) item).altitudeMeters(), null);
            case WAYPOINT -> {
                MissionItem.Waypoint waypoint = (MissionItem.Waypoint) item;
                yield placed(type, waypoint.point(), waypoint.altitude(), waypoint.holdSeconds());
            }
            case WAIT -> plain(type, null, ((MissionItem.Wait) item).seconds());
            case LOOK_AT ->
                placed(type, ((MissionItem.LookAt) item).point(), ((MissionItem.LookAt) item).altitude(), null);
            case SET_SERVO -> servo(type, (MissionItem.SetServo) item);
            case OTHER ->
                new MissionItemView(
                        type, null, null, null, null, null, null, null, ((MissionItem.Other) item).description());
            case RETURN_TO_LAUNCH, LAND, TAKE_PHOTO, LOOK_AHEAD -> plain(type, null, null);
        };
    }

    private static MissionItemView servo(String type, MissionItem.SetServo servo) {
        return new MissionItemView(type, null, null, null, null, null, servo.output(), servo.pulseMicros(), null);
    }

    public static List<MissionItemView> of(List<MissionItem> items) {
        return items.stream().map(MissionItemView::of).toList();
    }
}
