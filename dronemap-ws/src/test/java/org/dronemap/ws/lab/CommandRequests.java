package org.dronemap.ws.lab;

import java.util.List;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.VehicleDataRequest;
import org.dronemap.ws.mission.MissionItemRequest;
import org.jspecify.annotations.Nullable;

/** Commands as clients ask for them, without ids and epochs of their own. */
public final class CommandRequests {
    private CommandRequests() {}

    public static CommandRequest arm() {
        return new CommandRequest.Arm(null, null);
    }

    public static CommandRequest disarm() {
        return new CommandRequest.Disarm(null, null, null);
    }

    public static CommandRequest setMode(String mode) {
        return new CommandRequest.SetMode(mode, null, null);
    }

    public static CommandRequest takeOff(@Nullable Double altitude) {
        return new CommandRequest.TakeOff(altitude, null, null);
    }

    public static CommandRequest land() {
        return new CommandRequest.Land(null, null);
    }

    public static CommandRequest returnToLaunch() {
        return new CommandRequest.ReturnToLaunch(null, null);
    }

    public static CommandRequest hold() {
        return new CommandRequest.Hold(null, null);
    }

    public static CommandRequest goTo(double latitude, double longitude, double altitude) {
        return new CommandRequest.GoTo(latitude, longitude, altitude, null, null, null);
    }

    public static CommandRequest goToLocal(double x, double y) {
        return new CommandRequest.GoToLocal(x, y, null, null);
    }

    public static CommandRequest uploadMission(List<MissionItemRequest> items) {
        return new CommandRequest.UploadMission(items, null, null);
    }

    public static CommandRequest startMission(@Nullable String onCloudLoss) {
        return new CommandRequest.StartMission(onCloudLoss, null, null);
    }

    public static CommandRequest pauseMission() {
        return new CommandRequest.PauseMission(null, null);
    }

    public static CommandRequest clearMission() {
        return new CommandRequest.ClearMission(null, null);
    }

    public static CommandRequest changeSpeed(double metersPerSecond) {
        return new CommandRequest.ChangeSpeed(metersPerSecond, null, null);
    }

    public static CommandRequest turn(double degrees) {
        return new CommandRequest.Turn(degrees, null, null);
    }

    public static CommandRequest takePicture() {
        return new CommandRequest.TakePicture(null, null);
    }

    public static CommandRequest setRelay(int relay, String setting) {
        return new CommandRequest.SetRelay(relay, setting, null, null);
    }

    /** To where the vehicle is. */
    public static CommandRequest setHome() {
        return new VehicleDataRequest.SetHome(null, null, null, null, null, null);
    }

    /** The altitude is above sea level. */
    public static CommandRequest setHome(
            @Nullable Double latitude, @Nullable Double longitude, @Nullable Double altitudeAmsl) {
        return new VehicleDataRequest.SetHome(latitude, longitude, altitudeAmsl, "amsl", null, null);
    }

    public static CommandRequest readHome() {
        return new VehicleDataRequest.ReadHome(null, null);
    }

    public static CommandRequest readParameters() {
        return new VehicleDataRequest.ReadParameters(null, null);
    }
}
