package org.dronemap.ws.command;

import static io.swagger.v3.oas.annotations.media.Schema.RequiredMode.REQUIRED;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Pattern;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** A command that reads or changes what a vehicle keeps, and moves nothing: home, parameters, logs, its map. */
public sealed interface VehicleDataRequest extends CommandRequest {
    @Schema(name = "SetHomeCommand", description = "Move home; without a place to where the vehicle is.")
    record SetHome(
            @Schema(description = "Degrees") @Min(-FieldRanges.LATITUDE) @Max(FieldRanges.LATITUDE) @Nullable
            Double latitude,

            @Schema(description = "Degrees") @Min(-FieldRanges.LONGITUDE) @Max(FieldRanges.LONGITUDE) @Nullable
            Double longitude,

            @Schema(description = "Metres")
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
            implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return CommandReader.home(this);
        }
    }

    @Schema(name = "ReadHomeCommand", description = "Ask the vehicle where its home is.")
    record ReadHome(@Nullable String id, @Nullable Long epoch) implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.ReadHome();
        }
    }

    @Schema(name = "ReadParametersCommand", description = "Read all parameters of the vehicle.")
    record ReadParameters(@Nullable String id, @Nullable Long epoch) implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.ReadParameters();
        }
    }

    @Schema(name = "SetParametersCommand", description = "Change parameters of the vehicle.")
    record SetParameters(
            @Schema(requiredMode = REQUIRED, description = "What is to be changed")
            @Size(min = 1, max = ParameterReader.MOST)
            @Nullable
            List<ParameterRequest> parameters,

            @Nullable String id,
            @Nullable Long epoch)
            implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new Command.SetParameters(ParameterReader.read(parameters, held));
        }
    }

    @Schema(name = "ReadLogsCommand", description = "List the logs on the vehicle.")
    record ReadLogs(@Nullable String id, @Nullable Long epoch) implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.ReadLogs();
        }
    }

    @Schema(name = "ReadMapCommand", description = "Ask the vehicle for the map that it goes by.")
    record ReadMap(@Nullable String id, @Nullable Long epoch) implements VehicleDataRequest {
        @Override
        public Command command(DroneState drone, ParameterSet held) {
            return new org.dronemap.core.command.ReadMap();
        }
    }

    /** A parameter and the value that it shall get. */
    @Schema(name = "CommandParameterRequest")
    record ParameterRequest(
            @Pattern(regexp = ParameterValue.NAME) @Nullable String name,
            @Nullable Double value) {}
}
