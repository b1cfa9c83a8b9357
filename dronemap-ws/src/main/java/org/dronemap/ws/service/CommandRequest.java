package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A command as a client writes it; which members are needed depends on the type. Nothing is checked yet. */
@Schema(description = "A command; which members are needed depends on the type.")
public record CommandRequest(
        @Schema(description = "one of " + CommandRequest.TYPES, requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
        String type,

        @Schema(description = "Your own id (8 to 64 of A-Z a-z 0-9 _ -): the same id twice acts once") @Nullable
        String id,

        @Schema(description = "disarm: stop the motors even in the air") @Nullable
        Boolean force,

        @Schema(description = "setMode: one of the drone's modes") @Nullable
        String mode,

        @Schema(description = "goTo, setHome: degrees; setHome without a place means where the vehicle is") @Nullable
        Double latitude,

        @Schema(description = "goTo, setHome: degrees") @Nullable
        Double longitude,

        @Schema(description = "takeOff, goTo, setHome: metres") @Nullable
        Double altitude,

        @Schema(description = "goTo, setHome: home as it is now (the default) or amsl") @Nullable
        String altitudeReference,

        @Schema(description = "uploadMission: 1 to 500 items") @Nullable
        List<MissionItemView> items,

        @Schema(
                description = "startMission: what the vehicle does by itself when it no longer hears the cloud:"
                        + " continue (the default) or rtl")
        @Nullable
        String onCloudLoss,

        @Schema(description = "turn: degrees from where it looks now, clockwise when positive") @Nullable
        Double degrees,

        @Schema(description = "setRelay: 0 to 15") @Nullable Integer relay,

        @Schema(description = "setRelay: off, on or toggle") @Nullable
        String setting,

        @Schema(description = "setParameters: what is to be changed") @Nullable
        List<ParameterRequest> parameters,

        @Schema(description = "The epoch of the control that you believe to have: refused when that has ended")
        @Nullable
        Long epoch) {
    /** What there is of types; fence, rally points and the download of a log have addresses of their own. */
    static final String TYPES = "arm, disarm, setMode, takeOff, land, returnToLaunch, hold, goTo, uploadMission,"
            + " startMission, pauseMission, clearMission, turn, takePicture, setRelay, setHome, readHome,"
            + " readParameters, setParameters, readLogs";

    /** A parameter and the value that it shall get. */
    public record ParameterRequest(
            @Nullable String name, @Nullable Double value) {}

    CommandRequest withId(String given) {
        return new CommandRequest(
                type,
                given,
                force,
                mode,
                latitude,
                longitude,
                altitude,
                altitudeReference,
                items,
                onCloudLoss,
                degrees,
                relay,
                setting,
                parameters,
                epoch);
    }

    /** A command without parameters. */
    public static CommandRequest simple(String type) {
        return new CommandRequest(
                type, null, null, null, null, null, null, null, null, null, null, null, null, null, null);
    }

    public static CommandRequest disarm(@Nullable Boolean force) {
        return new CommandRequest(
                "disarm", null, force, null, null, null, null, null, null, null, null, null, null, null, null);
    }

    public static CommandRequest setMode(@Nullable String mode) {
        return new CommandRequest(
                "setMode", null, null, mode, null, null, null, null, null, null, null, null, null, null, null);
    }

    public static CommandRequest takeOff(@Nullable Double altitude) {
        return new CommandRequest(
                "takeOff", null, null, null, null, null, altitude, null, null, null, null, null, null, null, null);
    }

    public static CommandRequest goTo(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitude) {
        return new CommandRequest(
                "goTo", null, null, null, latitude, longitude, altitude, null, null, null, null, null, null, null,
                null);
    }

    public static CommandRequest uploadMission(@Nullable List<MissionItemView> items) {
        return new CommandRequest(
                "uploadMission", null, null, null, null, null, null, null, items, null, null, null, null, null, null);
    }

    public static CommandRequest startMission(@Nullable String onCloudLoss) {
        return new CommandRequest(
                "startMission",
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                onCloudLoss,
                null,
                null,
                null,
                null,
                null);
    }

    public static CommandRequest turn(@Nullable Double degrees) {
        return new CommandRequest(
                "turn", null, null, null, null, null, null, null, null, null, degrees, null, null, null, null);
    }

    public static CommandRequest setRelay(@Nullable Integer relay, @Nullable String setting) {
        return new CommandRequest(
                "setRelay", null, null, null, null, null, null, null, null, null, null, relay, setting, null, null);
    }

    /** The altitude is above sea level; all three null: where the vehicle is. */
    public static CommandRequest setHome(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAmsl) {
        return new CommandRequest(
                "setHome",
                null,
                null,
                null,
                latitude,
                longitude,
                altitudeAmsl,
                "amsl",
                null,
                null,
                null,
                null,
                null,
                null,
                null);
    }

    public static CommandRequest setParameter(@Nullable String name, @Nullable Double value) {
        return new CommandRequest(
                "setParameters",
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                List.of(new ParameterRequest(name, value)),
                null);
    }
}
