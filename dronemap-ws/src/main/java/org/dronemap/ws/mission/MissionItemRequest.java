package org.dronemap.ws.mission;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** One step of a mission as clients write it, and read it again; one record for each type. Nothing is checked yet. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = MissionItemRequest.TakeOff.class, name = "takeOff"),
    @JsonSubTypes.Type(value = MissionItemRequest.Waypoint.class, name = "waypoint"),
    @JsonSubTypes.Type(value = MissionItemRequest.ReturnToLaunch.class, name = "returnToLaunch"),
    @JsonSubTypes.Type(value = MissionItemRequest.Land.class, name = "land"),
    @JsonSubTypes.Type(value = MissionItemRequest.Wait.class, name = "wait"),
    @JsonSubTypes.Type(value = MissionItemRequest.TakePhoto.class, name = "takePhoto"),
    @JsonSubTypes.Type(value = MissionItemRequest.SetServo.class, name = "setServo"),
    @JsonSubTypes.Type(value = MissionItemRequest.LookAt.class, name = "lookAt"),
    @JsonSubTypes.Type(value = MissionItemRequest.LookAhead.class, name = "lookAhead")
})
@Schema(
        name = "MissionItemRequest",
        description = "One step of a mission; which members there are depends on the type.")
public sealed interface MissionItemRequest extends MissionItemView {
    /**
     * Throws {@link InvalidInput} where a member cannot be used.
     *
     * @param at what stands before its members' names, such as {@code items[2].}
     */
    MissionItem read(String at);

    @Schema(name = "TakeOffItem", description = "Climb straight up.")
    record TakeOff(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Metres above home, 1 to 500 when written")
            @Nullable
            Double altitude)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.TakeOff(FieldRanges.takeOffAltitude(at + "altitude", altitude));
        }
    }

    @Schema(name = "WaypointItem", description = "Fly through a point, or wait there.")
    record Waypoint(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres") @Nullable
            Double altitude,

            @Schema(description = "home (the default) or amsl") @EnumValues(Altitude.Reference.class) @Nullable
            String altitudeReference,

            @Schema(description = "Seconds to wait there, 0 to 3600 when written; left out: 0") @Nullable
            Double holdSeconds)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.Waypoint(
                    FieldRanges.point(at, latitude, longitude),
                    MissionReader.altitude(at, altitude, altitudeReference),
                    holdSeconds == null ? 0 : FieldRanges.holdSeconds(at + "holdSeconds", holdSeconds));
        }
    }

    @Schema(name = "ReturnToLaunchItem", description = "Fly home and land there.")
    record ReturnToLaunch() implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.ReturnToLaunch();
        }
    }

    @Schema(name = "LandItem", description = "Land at a place, or, where the vehicle can, where it is.")
    record Land(
            @Schema(description = "Degrees; with longitude. Left out with it: where it is")
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(description = "Degrees") @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "Metres of the ground there; left out: as high as home") @Nullable
            Double altitude,

            @Schema(description = "home (the default) or amsl") @EnumValues(Altitude.Reference.class) @Nullable
            String altitudeReference)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.Land(MissionReader.landingPlace(at, this));
        }
    }

    @Schema(name = "WaitItem", description = "Wait in the air where it is.")
    record Wait(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Seconds, 0.1 to 3600 when written")
            @Nullable
            Double holdSeconds)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.Wait(FieldRanges.waitSeconds(at + "holdSeconds", holdSeconds));
        }
    }

    @Schema(name = "TakePhotoItem", description = "Take one picture.")
    record TakePhoto() implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.TakePhoto();
        }
    }

    @Schema(name = "SetServoItem", description = "Set an output of the vehicle.")
    record SetServo(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Which output, 1 to 32 when written")
            @Nullable
            Integer output,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Length of its pulses in microseconds, 500 to 2500 when written")
            @Nullable
            Integer pulse)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return MissionReader.servo(at, output, pulse);
        }
    }

    @Schema(name = "LookAtItem", description = "Camera and nose point to a place until the next lookAhead.")
    record LookAt(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres") @Nullable
            Double altitude,

            @Schema(description = "home (the default) or amsl") @EnumValues(Altitude.Reference.class) @Nullable
            String altitudeReference)
            implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.LookAt(
                    FieldRanges.point(at, latitude, longitude),
                    MissionReader.altitude(at, altitude, altitudeReference));
        }
    }

    @Schema(name = "LookAheadItem", description = "No place is looked at any more.")
    record LookAhead() implements MissionItemRequest {
        @Override
        public MissionItem read(String at) {
            return new MissionItem.LookAhead();
        }
    }

    /** Throws {@link IllegalArgumentException} for what is never uploaded. */
    static MissionItemRequest of(MissionItem item) {
        return switch (item.kind()) {
            case TAKE_OFF -> new TakeOff(((MissionItem.TakeOff) item).altitudeMeters());
            case WAYPOINT -> of((MissionItem.Waypoint) item);
            case RETURN_TO_LAUNCH -> new ReturnToLaunch();
            case LAND -> of(((MissionItem.Land) item).place());
            case WAIT -> new Wait(((MissionItem.Wait) item).seconds());
            case TAKE_PHOTO -> new TakePhoto();
            case SET_SERVO ->
                new SetServo(((MissionItem.SetServo) item).output(), ((MissionItem.SetServo) item).pulseMicros());
            case LOOK_AT -> of((MissionItem.LookAt) item);
            case LOOK_AHEAD -> new LookAhead();
            case OTHER -> throw new IllegalArgumentException(item + " is never uploaded");
        };
    }

    private static Waypoint of(MissionItem.Waypoint item) {
        Geodetic point = item.point();
        Altitude altitude = item.altitude();
        return new Waypoint(
                point.latitudeDegrees(),
                point.longitudeDegrees(),
                altitude.meters(),
                WireNames.camel(altitude.reference()),
                item.holdSeconds());
    }

    private static Land of(@Nullable LandingPlace place) {
        return place == null
                ? new Land(null, null, null, null)
                : new Land(
                        place.point().latitudeDegrees(),
                        place.point().longitudeDegrees(),
                        place.ground().meters(),
                        WireNames.camel(place.ground().reference()));
    }

    private static LookAt of(MissionItem.LookAt item) {
        Geodetic point = item.point();
        Altitude altitude = item.altitude();
        return new LookAt(
                point.latitudeDegrees(),
                point.longitudeDegrees(),
                altitude.meters(),
                WireNames.camel(altitude.reference()));
    }

    static List<MissionItemRequest> of(List<MissionItem> items) {
        return items.stream().map(MissionItemRequest::of).toList();
    }
}
