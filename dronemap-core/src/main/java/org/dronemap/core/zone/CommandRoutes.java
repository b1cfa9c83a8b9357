package org.dronemap.core.zone;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.mission.MissionItem;

/**
 * Predicts the route along which a command would send a drone, to be checked against zones; a return home or a landing
 * only for a warning.
 */
public final class CommandRoutes {
    private CommandRoutes() {}

    /** {@link PredictedRoute#NONE} for what moves nothing, and for what brings it down or home: that is never kept from it. */
    public static PredictedRoute of(DroneState drone, Command command) {
        return switch (command.kind().movement()) {
            case NONE, STANDS, TURNS, CHANGES_SPEED, COMES_DOWN -> PredictedRoute.NONE;
            case CLIMBS ->
                new MissionRouteBuilder(drone).takeOff(((Command.TakeOff) command).altitudeMeters(), "The take-off");
            case GOES -> to(drone, (Command.GoTo) command);
            case GOES_ON_ITS_MAP ->
                new PredictedRoute(List.of(), "Where the vehicle's own map lies on the Earth is not known");
            case TAKES_MISSION ->
                uploaded(drone, ((Command.UploadMission) command).mission().items());
            case FLIES_MISSION -> onBoard(drone);
            case CHANGES_MODE -> inMode(drone, ((Command.SetMode) command).mode());
        };
    }

    /**
     * Where a setpoint leads a drone within a short time, said as the command that leads there; empty when it leads nowhere, or
     * when sticks are moved and nobody knows where the drone is: without GPS they are what is left.
     */
    public static Optional<Command> ahead(DroneState drone, Setpoint setpoint) {
        return setpoint.isStill() ? Optional.empty() : new SetpointPredictor(drone).of(setpoint);
    }

    /** The way home and down, which is only warned of. */
    public static PredictedRoute home(DroneState drone) {
        return new MissionRouteBuilder(drone).through(List.of(new MissionItem.ReturnToLaunch()), 0);
    }

    /** Straight down. */
    public static PredictedRoute down(DroneState drone) {
        return new MissionRouteBuilder(drone).through(List.of(new MissionItem.Land()), 0);
    }

    private static PredictedRoute to(DroneState drone, Command.GoTo goTo) {
        return new MissionRouteBuilder(drone).flyTo(goTo.point(), goTo.altitude(), "the place");
    }

    private static PredictedRoute inMode(DroneState drone, String mode) {
        return drone.capabilities().steering(mode).equals(Optional.of(Steering.MISSION))
                ? onBoard(drone)
                : PredictedRoute.NONE;
    }

    private static PredictedRoute uploaded(DroneState drone, List<MissionItem> items) {
        MissionRouteBuilder walk = new MissionRouteBuilder(drone);
        boolean placed = drone.position() != null && drone.position().point() != null;
        return (placed || drone.airborne() ? walk : walk.fromAnywhere()).through(items, 0);
    }

    private static PredictedRoute onBoard(DroneState drone) {
        MissionProgress mission = drone.mission();
        List<MissionItem> items = mission.items();
        if (items == null) {
            return new PredictedRoute(List.of(), "Which mission is on the vehicle is not known");
        }
        Integer current = mission.current();
        boolean drives = drone.identification().kind().neverFlies();
        if (current == null || mission.complete() || !(drone.airborne() || drives)) {
            return new MissionRouteBuilder(drone).through(items, 0);
        }
        PredictedRoute onwards = new MissionRouteBuilder(drone).through(items, current);
        // The item that it says may be left from the mission before this one: then it begins at the first.
        return drives && mission.reached().isEmpty()
                ? onwards.or(new MissionRouteBuilder(drone).through(items, 0))
                : onwards;
    }
}
