package org.dronemap.ws.service;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Pattern;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.parameter.ParameterValue;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/**
 * A command as a client writes it, one record for each type with the members that this type has. Nothing is checked yet.
 * Fence, rally points and the download of a log have addresses of their own.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectsOnly.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = CommandRequest.Arm.class, name = "arm"),
    @JsonSubTypes.Type(value = CommandRequest.Disarm.class, name = "disarm"),
    @JsonSubTypes.Type(value = CommandRequest.SetMode.class, name = "setMode"),
    @JsonSubTypes.Type(value = CommandRequest.TakeOff.class, name = "takeOff"),
    @JsonSubTypes.Type(value = CommandRequest.Land.class, name = "land"),
    @JsonSubTypes.Type(value = CommandRequest.ReturnToLaunch.class, name = "returnToLaunch"),
    @JsonSubTypes.Type(value = CommandRequest.Hold.class, name = "hold"),
    @JsonSubTypes.Type(value = CommandRequest.GoTo.class, name = "goTo"),
    @JsonSubTypes.Type(value = CommandRequest.UploadMission.class, name = "uploadMission"),
    @JsonSubTypes.Type(value = CommandRequest.StartMission.class, name = "startMission"),
    @JsonSubTypes.Type(value = CommandRequest.PauseMission.class, name = "pauseMission"),
    @JsonSubTypes.Type(value = CommandRequest.ClearMission.class, name = "clearMission"),
    @JsonSubTypes.Type(value = CommandRequest.Turn.class, name = "turn"),
    @JsonSubTypes.Type(value = CommandRequest.TakePicture.class, name = "takePicture"),
    @JsonSubTypes.Type(value = CommandRequest.SetRelay.class, name = "setRelay"),
    @JsonSubTypes.Type(value = CommandRequest.SetHome.class, name = "setHome"),
    @JsonSubTypes.Type(value = CommandRequest.ReadHome.class, name = "readHome"),
    @JsonSubTypes.Type(value = CommandRequest.ReadParameters.class, name = "readParameters"),
    @JsonSubTypes.Type(value = CommandRequest.SetParameters.class, name = "setParameters"),
    @JsonSubTypes.Type(value = CommandRequest.ReadLogs.class, name = "readLogs"),
    @JsonSubTypes.Type(value = CommandRequest.GoToLocal.class, name = "goToLocal"),
    @JsonSubTypes.Type(value = CommandRequest.EmergencyStop.class, name = "emergencyStop"),
    @JsonSubTypes.Type(value = CommandRequest.ReadMap.class, name = "readMap")
})
@Schema(name = "CommandRequest", description = "A command; which members there are depends on the type.")
public sealed interface CommandRequest {
    CommandKind kind();

    @Schema(description = "Your own id (8 to 64 of A-Z a-z 0-9 _ -): the same id twice acts once")
    @Pattern(regexp = CommandService.ID)
    @Nullable
    String id();

    @Schema(description = "The epoch of the control that you believe to have: refused when that has ended")
    @Nullable
    Long epoch();

    @Schema(name = "ArmCommand", description = "Start the motors.")
    record Arm(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.ARM;
        }
    }

    @Schema(name = "DisarmCommand", description = "Stop the motors.")
    record Disarm(
            @Schema(description = "Even in the air") @Nullable
            Boolean force,

            @Nullable String id,
            @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.DISARM;
        }
    }

    @Schema(name = "SetModeCommand", description = "Change the mode.")
    record SetMode(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "One of the drone's modes") @Nullable
            String mode,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.SET_MODE;
        }
    }

    @Schema(name = "TakeOffCommand", description = "Climb straight up.")
    record TakeOff(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres above home")
            @Min(Ranges.LEAST_TAKE_OFF)
            @Max(Ranges.MOST_TAKE_OFF)
            @Nullable
            Double altitude,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.TAKE_OFF;
        }
    }

    @Schema(name = "LandCommand", description = "Land where it is.")
    record Land(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.LAND;
        }
    }

    @Schema(name = "ReturnToLaunchCommand", description = "Fly home and land there.")
    record ReturnToLaunch(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.RETURN_TO_LAUNCH;
        }
    }

    @Schema(name = "HoldCommand", description = "Stop and stay where it is.")
    record Hold(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.HOLD;
        }
    }

    @Schema(name = "GoToCommand", description = "Fly to a place and stay there.")
    record GoTo(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-Ranges.LATITUDE)
            @Max(Ranges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-Ranges.LONGITUDE)
            @Max(Ranges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(description = "home as it is now (the default) or amsl")
            @ValuesOf(Altitude.Reference.class)
            @Nullable
            String altitudeReference,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.GO_TO;
        }
    }

    @Schema(name = "UploadMissionCommand", description = "Bring a mission to the vehicle in place of the one it has.")
    record UploadMission(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "1 to 500 items")
            @Size(min = 1, max = Mission.MAX_ITEMS)
            @Nullable
            List<MissionItemRequest> items,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.UPLOAD_MISSION;
        }
    }

    @Schema(name = "StartMissionCommand", description = "Fly the mission on the vehicle.")
    record StartMission(
            @Schema(
                    description = "What the vehicle does by itself when it no longer hears the cloud:"
                            + " continue (the default) or rtl",
                    allowableValues = {"continue", "rtl"})
            @Nullable
            String onCloudLoss,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.START_MISSION;
        }
    }

    @Schema(name = "PauseMissionCommand", description = "Stop in its mission.")
    record PauseMission(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.PAUSE_MISSION;
        }
    }

    @Schema(name = "ClearMissionCommand", description = "Delete the mission on the vehicle.")
    record ClearMission(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.CLEAR_MISSION;
        }
    }

    @Schema(name = "TurnCommand", description = "Turn on the spot.")
    record Turn(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Degrees from where it looks now, clockwise when positive")
            @Min(-Ranges.MOST_TURN)
            @Max(Ranges.MOST_TURN)
            @Nullable
            Double degrees,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.TURN;
        }
    }

    @Schema(name = "TakePictureCommand", description = "Take one picture.")
    record TakePicture(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.TAKE_PICTURE;
        }
    }

    @Schema(name = "SetRelayCommand", description = "Switch a relay on the vehicle.")
    record SetRelay(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Which relay, 0 to 15")
            @Min(0)
            @Max(Ranges.LAST_RELAY)
            @Nullable
            Integer relay,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @ValuesOf(RelaySetting.class) @Nullable
            String setting,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.SET_RELAY;
        }
    }

    @Schema(name = "SetHomeCommand", description = "Move home; without a place to where the vehicle is.")
    record SetHome(
            @Schema(description = "Degrees") @Min(-Ranges.LATITUDE) @Max(Ranges.LATITUDE) @Nullable
            Double latitude,

            @Schema(description = "Degrees") @Min(-Ranges.LONGITUDE) @Max(Ranges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "Metres")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(description = "home as it is now (the default) or amsl")
            @ValuesOf(Altitude.Reference.class)
            @Nullable
            String altitudeReference,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.SET_HOME;
        }
    }

    @Schema(name = "ReadHomeCommand", description = "Ask the vehicle where its home is.")
    record ReadHome(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.READ_HOME;
        }
    }

    @Schema(name = "ReadParametersCommand", description = "Read all parameters of the vehicle.")
    record ReadParameters(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.READ_PARAMETERS;
        }
    }

    @Schema(name = "SetParametersCommand", description = "Change parameters of the vehicle.")
    record SetParameters(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "What is to be changed")
            @Size(min = 1, max = ParameterReader.MOST)
            @Nullable
            List<ParameterRequest> parameters,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.SET_PARAMETERS;
        }
    }

    @Schema(name = "ReadLogsCommand", description = "List the logs on the vehicle.")
    record ReadLogs(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.READ_LOGS;
        }
    }

    @Schema(name = "GoToLocalCommand", description = "Go to a place on the vehicle's own map.")
    record GoToLocal(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres along the x axis of that map")
            @Min(-Ranges.MOST_ON_MAP)
            @Max(Ranges.MOST_ON_MAP)
            @Nullable
            Double x,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Metres along the y axis of that map")
            @Min(-Ranges.MOST_ON_MAP)
            @Max(Ranges.MOST_ON_MAP)
            @Nullable
            Double y,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.GO_TO_LOCAL;
        }
    }

    @Schema(name = "EmergencyStopCommand", description = "Stand still at once, and give up whatever it was driving to.")
    record EmergencyStop(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.EMERGENCY_STOP;
        }
    }

    @Schema(name = "ReadMapCommand", description = "Ask the vehicle for the map that it goes by.")
    record ReadMap(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public CommandKind kind() {
            return CommandKind.READ_MAP;
        }
    }

    /** A parameter and the value that it shall get. */
    @Schema(name = "CommandParameterRequest")
    record ParameterRequest(
            @Pattern(regexp = ParameterValue.NAME) @Nullable String name,
            @Nullable Double value) {}
}
