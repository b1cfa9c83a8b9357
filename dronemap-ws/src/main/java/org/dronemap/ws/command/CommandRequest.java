package org.dronemap.ws.command;

import static io.swagger.v3.oas.annotations.media.Schema.RequiredMode.REQUIRED;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.DecimalMin;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Pattern;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.mission.MissionReader;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/**
 * A command to a drone as a client writes it; one record for each type of command, with its fields. Nothing is checked
 * yet. Fence, rally points and the download of a log have addresses of their own.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
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
    @JsonSubTypes.Type(value = CommandRequest.ChangeSpeed.class, name = "changeSpeed"),
    @JsonSubTypes.Type(value = CommandRequest.TakePicture.class, name = "takePicture"),
    @JsonSubTypes.Type(value = CommandRequest.SetRelay.class, name = "setRelay"),
    @JsonSubTypes.Type(value = VehicleDataRequest.SetHome.class, name = "setHome"),
    @JsonSubTypes.Type(value = VehicleDataRequest.ReadHome.class, name = "readHome"),
    @JsonSubTypes.Type(value = VehicleDataRequest.ReadParameters.class, name = "readParameters"),
    @JsonSubTypes.Type(value = VehicleDataRequest.SetParameters.class, name = "setParameters"),
    @JsonSubTypes.Type(value = VehicleDataRequest.ReadLogs.class, name = "readLogs"),
    @JsonSubTypes.Type(value = CommandRequest.GoToLocal.class, name = "goToLocal"),
    @JsonSubTypes.Type(value = CommandRequest.EmergencyStop.class, name = "emergencyStop"),
    @JsonSubTypes.Type(value = VehicleDataRequest.ReadMap.class, name = "readMap")
})
@Schema(name = "CommandRequest", description = "A command; which members there are depends on the type.")
public sealed interface CommandRequest
        permits CommandRequest.Arm,
                CommandRequest.Disarm,
                CommandRequest.SetMode,
                CommandRequest.TakeOff,
                CommandRequest.Land,
                CommandRequest.ReturnToLaunch,
                CommandRequest.Hold,
                CommandRequest.GoTo,
                CommandRequest.UploadMission,
                CommandRequest.StartMission,
                CommandRequest.PauseMission,
                CommandRequest.ClearMission,
                CommandRequest.Turn,
                CommandRequest.ChangeSpeed,
                CommandRequest.TakePicture,
                CommandRequest.SetRelay,
                CommandRequest.GoToLocal,
                CommandRequest.EmergencyStop,
                VehicleDataRequest {
    /** What it asks for, as it is called above. */
    default CommandKind kind() {
        return CommandReader.kind(this);
    }

    /**
     * What it asks for: the same whenever it is read, however the drone is by then. Says which member is wrong and what is
     * allowed.
     *
     * @param held the parameters that are known of the drone
     */
    Command command(DroneState drone, ParameterSet held);

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
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.Arm();
        }
    }

    @Schema(name = "DisarmCommand", description = "Stop the motors.")
    record Disarm(
            @Schema(description = "Even in the air") @Nullable
            Boolean force,

            @Nullable String id,
            @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.Disarm(Boolean.TRUE.equals(force));
        }
    }

    @Schema(name = "SetModeCommand", description = "Change the mode.")
    record SetMode(
            @Schema(requiredMode = REQUIRED, description = "One of the drone's modes") @Nullable
            String mode,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.SetMode(CommandReader.mode(mode, drone));
        }
    }

    @Schema(name = "TakeOffCommand", description = "Climb straight up.")
    record TakeOff(
            @Schema(requiredMode = REQUIRED, description = "Metres above home")
            @Min(FieldRanges.LEAST_TAKE_OFF)
            @Max(FieldRanges.MOST_TAKE_OFF)
            @Nullable
            Double altitude,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.TakeOff(FieldRanges.takeOffAltitude("altitude", altitude));
        }
    }

    @Schema(name = "LandCommand", description = "Land where it is.")
    record Land(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.Land();
        }
    }

    @Schema(name = "ReturnToLaunchCommand", description = "Fly home and land there.")
    record ReturnToLaunch(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.ReturnToLaunch();
        }
    }

    @Schema(name = "HoldCommand", description = "Stop and stay where it is.")
    record Hold(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.Hold();
        }
    }

    @Schema(name = "GoToCommand", description = "Fly to a place and stay there.")
    record GoTo(
            @Schema(requiredMode = REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(requiredMode = REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(requiredMode = REQUIRED, description = "Metres")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude,

            @Schema(description = "home as it is now (the default) or amsl")
            @EnumValues(Altitude.Reference.class)
            @Nullable
            String altitudeReference,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.GoTo(
                    CommandReader.place(latitude, longitude), MissionReader.altitude("", altitude, altitudeReference));
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
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.UploadMission(MissionReader.read(items));
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
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.StartMission(CommandReader.cloudLoss(onCloudLoss));
        }
    }

    @Schema(name = "PauseMissionCommand", description = "Stop in its mission.")
    record PauseMission(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.PauseMission();
        }
    }

    @Schema(name = "ClearMissionCommand", description = "Delete the mission on the vehicle.")
    record ClearMission(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.ClearMission();
        }
    }

    @Schema(name = "TurnCommand", description = "Turn on the spot.")
    record Turn(
            @Schema(requiredMode = REQUIRED, description = "Degrees from where it looks now, clockwise when positive")
            @Min(-FieldRanges.MOST_TURN)
            @Max(FieldRanges.MOST_TURN)
            @Nullable
            Double degrees,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.Turn(FieldRanges.turn("degrees", degrees));
        }
    }

    @Schema(name = "ChangeSpeedCommand", description = "Go on at another speed, until the mode changes.")
    record ChangeSpeed(
            @Schema(
                    requiredMode = REQUIRED,
                    description = "Over the ground, or through the air for a plane; 0.2 to 30 for copters and"
                            + " submarines, 3 to 100 for planes, 0.1 to 30 for what drives, 0.1 to 100 for others")
            @DecimalMin(FieldRanges.LEAST_SPEED)
            @Max(FieldRanges.MOST_SPEED)
            @Nullable
            Double metersPerSecond,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.ChangeSpeed(FieldRanges.speed("metersPerSecond", metersPerSecond));
        }
    }

    @Schema(name = "TakePictureCommand", description = "Take one picture.")
    record TakePicture(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.TakePicture();
        }
    }

    @Schema(name = "SetRelayCommand", description = "Switch a relay on the vehicle.")
    record SetRelay(
            @Schema(requiredMode = REQUIRED, description = "Which relay, 0 to 15")
            @Min(0)
            @Max(FieldRanges.LAST_RELAY)
            @Nullable
            Integer relay,

            @Schema(requiredMode = REQUIRED) @EnumValues(RelaySetting.class) @Nullable
            String setting,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.SetRelay(FieldRanges.relay("relay", relay), CommandReader.relaySetting(setting));
        }
    }

    @Schema(name = "GoToLocalCommand", description = "Go to a place on the vehicle's own map.")
    record GoToLocal(
            @Schema(requiredMode = REQUIRED, description = "Metres along the x axis of that map")
            @Min(-FieldRanges.MOST_ON_MAP)
            @Max(FieldRanges.MOST_ON_MAP)
            @Nullable
            Double x,

            @Schema(requiredMode = REQUIRED, description = "Metres along the y axis of that map")
            @Min(-FieldRanges.MOST_ON_MAP)
            @Max(FieldRanges.MOST_ON_MAP)
            @Nullable
            Double y,

            @Nullable String id,
            @Nullable Long epoch)
            implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.GoToLocal(FieldRanges.onMap("x", x), FieldRanges.onMap("y", y), null);
        }
    }

    @Schema(name = "EmergencyStopCommand", description = "Stand still at once, and give up whatever it was driving to.")
    record EmergencyStop(@Nullable String id, @Nullable Long epoch) implements CommandRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.EmergencyStop();
        }
    }
}
