package org.dronemap.ws.command;

import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.mission.MissionReader;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Checks the fields of a client's command, and turns them into values of a core command or rejects the request. */
final class CommandReader {
    private static final String RELAY_SETTINGS = "off, on or toggle";
    private static final String CLOUD_LOSS = "continue or rtl";

    private static final Map<Class<?>, CommandKind> KINDS = kinds();

    private CommandReader() {}

    static CommandKind kind(CommandRequest request) {
        return Objects.requireNonNull(KINDS.get(request.getClass()));
    }

    private static Map<Class<?>, CommandKind> kinds() {
        Map<String, CommandKind> named = Stream.of(CommandKind.values())
                .collect(Collectors.toMap(kind -> WireNames.lowerFirst(kind.word()), kind -> kind));
        return RecordAlternatives.of(CommandRequest.class).orElseThrow().records().entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(
                        Map.Entry::getValue,
                        one -> Objects.requireNonNull(
                                named.get(one.getKey()), "No command is called " + one.getKey())));
    }

    /** What the drone needs beside what was asked. */
    static Command complete(Command asked, DroneState drone) {
        return asked instanceof Command.UploadMission upload
                ? new Command.UploadMission(
                        TakeOffInserter.complete(VehicleMissionCheck.checked(upload.mission(), drone), drone))
                : asked;
    }

    static Geodetic place(@Nullable Double latitude, @Nullable Double longitude) {
        return new Geodetic(FieldRanges.latitude("latitude", latitude), FieldRanges.longitude("longitude", longitude));
    }

    /** Without a place: where the vehicle is. */
    static Command.SetHome home(VehicleDataRequest.SetHome request) {
        boolean here = request.latitude() == null && request.longitude() == null && request.altitude() == null;
        return here
                ? new Command.SetHome(null, null)
                : new Command.SetHome(
                        place(request.latitude(), request.longitude()),
                        MissionReader.altitude("", request.altitude(), request.altitudeReference()));
    }

    /** The exact name; names differ by vehicle, so the gate judges which there are. */
    static String mode(@Nullable String mode, DroneState drone) {
        if (mode == null || mode.isBlank()) {
            throw InvalidInput.missing(
                    "mode", "one of " + String.join(", ", drone.capabilities().modes()));
        }
        return mode.strip();
    }

    static RelaySetting relaySetting(@Nullable String value) {
        return switch (value == null ? "" : value) {
            case "off" -> RelaySetting.OFF;
            case "on" -> RelaySetting.ON;
            case "toggle" -> RelaySetting.TOGGLE;
            case "" -> throw InvalidInput.missing("setting", RELAY_SETTINGS);
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "setting", RELAY_SETTINGS, "\"" + value + "\"");
        };
    }

    static MissionCloudLossPolicy cloudLoss(@Nullable String value) {
        return switch (value == null ? "continue" : value) {
            case "continue" -> MissionCloudLossPolicy.CONTINUE;
            case "rtl" -> MissionCloudLossPolicy.RETURN_TO_LAUNCH;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "onCloudLoss", CLOUD_LOSS, "\"" + value + "\"");
        };
    }
}
