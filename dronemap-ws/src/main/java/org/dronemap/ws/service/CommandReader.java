package org.dronemap.ws.service;

import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/** Turns what a client wrote into a command, or says which member is wrong and what is allowed. */
final class CommandReader {
    private static final String KINDS = "one of " + CommandRequest.TYPES;
    private static final String RELAY_SETTINGS = "off, on or toggle";
    private static final String CLOUD_LOSS = "continue or rtl";

    private CommandReader() {}

    static Command read(CommandRequest request, DroneState drone, ParameterSet held) {
        String type = request.type();
        if (type == null) {
            throw InvalidInput.missing("type", KINDS);
        }
        return switch (type) {
            case "arm" -> new Command.Arm();
            case "disarm" -> new Command.Disarm(Boolean.TRUE.equals(request.force()));
            case "setMode" -> new Command.SetMode(mode(request.mode(), drone));
            case "takeOff" -> new Command.TakeOff(Ranges.takeOffAltitude("altitude", request.altitude()));
            case "land" -> new Command.Land();
            case "returnToLaunch" -> new Command.ReturnToLaunch();
            case "hold" -> new Command.Hold();
            case "goTo" -> goTo(request);
            case "goToLocal" -> new GoToLocal(Ranges.onMap("x", request.x()), Ranges.onMap("y", request.y()), null);
            case "emergencyStop" -> new EmergencyStop();
            case "readMap" -> new ReadMap();
            case "uploadMission" ->
                new Command.UploadMission(TakeOffFirst.complete(MissionReader.read(request.items()), drone));
            case "startMission" -> new Command.StartMission(cloudLoss(request.onCloudLoss()));
            case "turn" -> new Command.Turn(Ranges.turn("degrees", request.degrees()));
            case "takePicture" -> new Command.TakePicture();
            case "setRelay" ->
                new Command.SetRelay(Ranges.relay("relay", request.relay()), relaySetting(request.setting()));
            case "setHome" -> setHome(request);
            case "readHome" -> new Command.ReadHome();
            case "readLogs" -> new Command.ReadLogs();
            case "readParameters" -> new Command.ReadParameters();
            case "setParameters" -> new Command.SetParameters(ParameterReader.read(request.parameters(), held));
            case "pauseMission" -> new Command.PauseMission();
            case "clearMission" -> new Command.ClearMission();
            default -> throw InvalidInput.outside("type", KINDS, "\"" + type + "\"");
        };
    }

    private static Command.GoTo goTo(CommandRequest request) {
        Geodetic point = new Geodetic(
                Ranges.latitude("latitude", request.latitude()), Ranges.longitude("longitude", request.longitude()));
        return new Command.GoTo(point, MissionReader.altitude("", request.altitude(), request.altitudeReference()));
    }

    /** Without a place: where the vehicle is. */
    private static Command.SetHome setHome(CommandRequest request) {
        boolean here = request.latitude() == null && request.longitude() == null && request.altitude() == null;
        if (here) {
            return new Command.SetHome(null, null);
        }
        Geodetic point = new Geodetic(
                Ranges.latitude("latitude", request.latitude()), Ranges.longitude("longitude", request.longitude()));
        return new Command.SetHome(point, MissionReader.altitude("", request.altitude(), request.altitudeReference()));
    }

    /** The exact name; names differ by vehicle, so the gate judges which there are. */
    private static String mode(@Nullable String mode, DroneState drone) {
        if (mode == null || mode.isBlank()) {
            throw InvalidInput.missing(
                    "mode", "one of " + String.join(", ", drone.capabilities().modes()));
        }
        return mode.strip();
    }

    private static RelaySetting relaySetting(@Nullable String value) {
        return switch (value == null ? "" : value) {
            case "off" -> RelaySetting.OFF;
            case "on" -> RelaySetting.ON;
            case "toggle" -> RelaySetting.TOGGLE;
            case "" -> throw InvalidInput.missing("setting", RELAY_SETTINGS);
            default -> throw InvalidInput.outside("setting", RELAY_SETTINGS, "\"" + value + "\"");
        };
    }

    private static CloudLoss cloudLoss(@Nullable String value) {
        return switch (value == null ? "continue" : value) {
            case "continue" -> CloudLoss.CONTINUE;
            case "rtl" -> CloudLoss.RETURN_TO_LAUNCH;
            default -> throw InvalidInput.outside("onCloudLoss", CLOUD_LOSS, "\"" + value + "\"");
        };
    }
}
