package org.dronemap.ws.service;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/** A command as a client writes it; which members are needed depends on the type. Nothing is checked yet. */
@Schema(name = "CommandRequest", description = "A command; which members are needed depends on the type.")
public record CommandRequest(
        @Schema(
                requiredMode = Schema.RequiredMode.REQUIRED,
                allowableValues = {
                    "arm",
                    "disarm",
                    "setMode",
                    "takeOff",
                    "land",
                    "returnToLaunch",
                    "hold",
                    "goTo",
                    "uploadMission",
                    "startMission",
                    "pauseMission",
                    "clearMission",
                    "turn",
                    "takePicture",
                    "setRelay",
                    "setHome",
                    "readHome",
                    "readParameters",
                    "setParameters",
                    "readLogs",
                    "goToLocal",
                    "emergencyStop",
                    "readMap"
                })
        @Nullable
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

        @Schema(description = "goToLocal: metres along the x axis of the vehicle's own map") @Nullable
        Double x,

        @Schema(description = "goToLocal: metres along the y axis of the vehicle's own map") @Nullable
        Double y,

        @Schema(description = "takeOff, goTo, setHome: metres") @Nullable
        Double altitude,

        @Schema(description = "goTo, setHome: home as it is now (the default) or amsl")
        @ValuesOf(Altitude.Reference.class)
        @Nullable
        String altitudeReference,

        @Schema(description = "uploadMission: 1 to 500 items") @Nullable
        List<MissionItemView> items,

        @Schema(
                description = "startMission: what the vehicle does by itself when it no longer hears the cloud:"
                        + " continue (the default) or rtl",
                allowableValues = {"continue", "rtl"})
        @Nullable
        String onCloudLoss,

        @Schema(description = "turn: degrees from where it looks now, clockwise when positive") @Nullable
        Double degrees,

        @Schema(description = "setRelay: 0 to 15") @Nullable Integer relay,

        @Schema(description = "setRelay") @ValuesOf(RelaySetting.class) @Nullable
        String setting,

        @Schema(description = "setParameters: what is to be changed") @Nullable
        List<ParameterRequest> parameters,

        @Schema(description = "The epoch of the control that you believe to have: refused when that has ended")
        @Nullable
        Long epoch) {
    /** What there is of types; fence, rally points and the download of a log have addresses of their own. */
    static final String TYPES = "arm, disarm, setMode, takeOff, land, returnToLaunch, hold, goTo, uploadMission,"
            + " startMission, pauseMission, clearMission, turn, takePicture, setRelay, setHome, readHome,"
            + " readParameters, setParameters, readLogs, goToLocal, emergencyStop, readMap";

    /** A parameter and the value that it shall get. */
    @Schema(name = "CommandParameterRequest")
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
                x,
                y,
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
        return new Draft(type).request();
    }

    public static CommandRequest disarm(@Nullable Boolean force) {
        Draft draft = new Draft("disarm");
        draft.force = force;
        return draft.request();
    }

    public static CommandRequest setMode(@Nullable String mode) {
        Draft draft = new Draft("setMode");
        draft.mode = mode;
        return draft.request();
    }

    public static CommandRequest takeOff(@Nullable Double altitude) {
        Draft draft = new Draft("takeOff");
        draft.altitude = altitude;
        return draft.request();
    }

    public static CommandRequest goTo(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitude) {
        return new Draft("goTo").at(latitude, longitude, altitude).request();
    }

    public static CommandRequest goToLocal(@Nullable Double x, @Nullable Double y) {
        Draft draft = new Draft("goToLocal");
        draft.x = x;
        draft.y = y;
        return draft.request();
    }

    public static CommandRequest uploadMission(@Nullable List<MissionItemView> items) {
        Draft draft = new Draft("uploadMission");
        draft.items = items;
        return draft.request();
    }

    public static CommandRequest startMission(@Nullable String onCloudLoss) {
        Draft draft = new Draft("startMission");
        draft.onCloudLoss = onCloudLoss;
        return draft.request();
    }

    public static CommandRequest turn(@Nullable Double degrees) {
        Draft draft = new Draft("turn");
        draft.degrees = degrees;
        return draft.request();
    }

    public static CommandRequest setRelay(@Nullable Integer relay, @Nullable String setting) {
        Draft draft = new Draft("setRelay");
        draft.relay = relay;
        draft.setting = setting;
        return draft.request();
    }

    /** The altitude is above sea level; all three null: where the vehicle is. */
    public static CommandRequest setHome(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAmsl) {
        Draft draft = new Draft("setHome").at(latitude, longitude, altitudeAmsl);
        draft.altitudeReference = "amsl";
        return draft.request();
    }

    public static CommandRequest setParameter(@Nullable String name, @Nullable Double value) {
        Draft draft = new Draft("setParameters");
        draft.parameters = List.of(new ParameterRequest(name, value));
        return draft.request();
    }

    /** What is not set stays out. Owned by the method that makes it. */
    private static final class Draft {
        private final String type;
        private @Nullable Boolean force;
        private @Nullable String mode;
        private @Nullable Double latitude;
        private @Nullable Double longitude;
        private @Nullable Double x;
        private @Nullable Double y;
        private @Nullable Double altitude;
        private @Nullable String altitudeReference;
        private @Nullable List<MissionItemView> items;
        private @Nullable String onCloudLoss;
        private @Nullable Double degrees;
        private @Nullable Integer relay;
        private @Nullable String setting;
        private @Nullable List<ParameterRequest> parameters;

        Draft(String type) {
            this.type = type;
        }

        Draft at(@Nullable Double atLatitude, @Nullable Double atLongitude, @Nullable Double atAltitude) {
            latitude = atLatitude;
            longitude = atLongitude;
            altitude = atAltitude;
            return this;
        }

        CommandRequest request() {
            return new CommandRequest(
                    type,
                    null,
                    force,
                    mode,
                    latitude,
                    longitude,
                    x,
                    y,
                    altitude,
                    altitudeReference,
                    items,
                    onCloudLoss,
                    degrees,
                    relay,
                    setting,
                    parameters,
                    null);
        }
    }
}
