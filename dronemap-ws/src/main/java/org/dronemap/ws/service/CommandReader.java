package org.dronemap.ws.service;

import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.ReadHome;
import org.dronemap.core.command.ReadLogs;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/** Turns what a client wrote into a command, or says which member is wrong and what is allowed. */
final class CommandReader {
    private static final String RELAY_SETTINGS = "off, on or toggle";
    private static final String CLOUD_LOSS = "continue or rtl";

    private CommandReader() {}

    /** The same whenever it is asked, however the drone is by then. */
    static Command asked(CommandRequest request, DroneState drone, ParameterSet held) {
        return switch (request.kind()) {
            case ARM -> new Command.Arm();
            case DISARM -> new Command.Disarm(Boolean.TRUE.equals(((CommandRequest.Disarm) request).force()));
            case SET_MODE -> new Command.SetMode(mode(((CommandRequest.SetMode) request).mode(), drone));
            case TAKE_OFF -> takeOff((CommandRequest.TakeOff) request);
            case LAND -> new Command.Land();
            case RETURN_TO_LAUNCH -> new Command.ReturnToLaunch();
            case HOLD -> new Command.Hold();
            case GO_TO -> goTo((CommandRequest.GoTo) request);
            case GO_TO_LOCAL -> goToLocal((CommandRequest.GoToLocal) request);
            case EMERGENCY_STOP -> new EmergencyStop();
            case READ_MAP -> new ReadMap();
            case UPLOAD_MISSION ->
                new Command.UploadMission(MissionReader.read(((CommandRequest.UploadMission) request).items()));
            case START_MISSION ->
                new Command.StartMission(cloudLoss(((CommandRequest.StartMission) request).onCloudLoss()));
            case TURN -> new Command.Turn(Ranges.turn("degrees", ((CommandRequest.Turn) request).degrees()));
            case TAKE_PICTURE -> new Command.TakePicture();
            case SET_RELAY -> setRelay((CommandRequest.SetRelay) request);
            case SET_HOME -> setHome((CommandRequest.SetHome) request);
            case READ_HOME -> new ReadHome();
            case READ_LOGS -> new ReadLogs();
            case READ_PARAMETERS -> new Command.ReadParameters();
            case SET_PARAMETERS -> setParameters((CommandRequest.SetParameters) request, held);
            case PAUSE_MISSION -> new Command.PauseMission();
            case CLEAR_MISSION -> new Command.ClearMission();
            // These have addresses of their own, or are given by the cloud alone.
            case READ_FENCE,
                    SET_FENCE,
                    READ_RALLY_POINTS,
                    SET_RALLY_POINTS,
                    DOWNLOAD_LOG,
                    SET_RETURN_HEIGHT,
                    RETURN_ON_LOSS,
                    SET_CLOUD_LOSS,
                    PUT_BACK -> throw new IllegalStateException(request + " is of no kind that clients ask for");
        };
    }

    /** What the drone needs beside what was asked. */
    static Command complete(Command asked, DroneState drone) {
        return asked instanceof Command.UploadMission upload
                ? new Command.UploadMission(TakeOffFirst.complete(upload.mission(), drone))
                : asked;
    }

    private static Command.TakeOff takeOff(CommandRequest.TakeOff request) {
        return new Command.TakeOff(Ranges.takeOffAltitude("altitude", request.altitude()));
    }

    private static Command.SetParameters setParameters(CommandRequest.SetParameters request, ParameterSet held) {
        return new Command.SetParameters(ParameterReader.read(request.parameters(), held));
    }

    private static Command.GoTo goTo(CommandRequest.GoTo request) {
        Geodetic point = new Geodetic(
                Ranges.latitude("latitude", request.latitude()), Ranges.longitude("longitude", request.longitude()));
        return new Command.GoTo(point, MissionReader.altitude("", request.altitude(), request.altitudeReference()));
    }

    private static GoToLocal goToLocal(CommandRequest.GoToLocal request) {
        return new GoToLocal(Ranges.onMap("x", request.x()), Ranges.onMap("y", request.y()), null);
    }

    private static Command.SetRelay setRelay(CommandRequest.SetRelay request) {
        return new Command.SetRelay(Ranges.relay("relay", request.relay()), relaySetting(request.setting()));
    }

    /** Without a place: where the vehicle is. */
    private static Command.SetHome setHome(CommandRequest.SetHome request) {
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
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "setting", RELAY_SETTINGS, "\"" + value + "\"");
        };
    }

    private static CloudLoss cloudLoss(@Nullable String value) {
        return switch (value == null ? "continue" : value) {
            case "continue" -> CloudLoss.CONTINUE;
            case "rtl" -> CloudLoss.RETURN_TO_LAUNCH;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "onCloudLoss", CLOUD_LOSS, "\"" + value + "\"");
        };
    }
}
