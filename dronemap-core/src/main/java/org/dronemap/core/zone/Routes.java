package org.dronemap.core.zone;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionItem;

/** Which way a command sends a drone. */
public final class Routes {
    private Routes() {}

    /** {@link Route#NONE} for what moves nothing, and for what brings it down or home: that is never kept from it. */
    public static Route of(DroneState drone, Command command) {
        if (command instanceof Command.TakeOff takeOff) {
            return new MissionWalk(drone).takeOff(takeOff.altitudeMeters(), "The take-off");
        }
        if (command instanceof Command.GoTo goTo) {
            return new MissionWalk(drone).flyTo(goTo.point(), goTo.altitude(), "the place");
        }
        if (command instanceof GoToLocal) {
            return new Route(List.of(), "Where the vehicle's own map lies on the Earth is not known");
        }
        if (command instanceof Command.UploadMission upload) {
            return uploaded(drone, upload.mission().items());
        }
        if (command instanceof Command.StartMission
                || (command instanceof Command.SetMode mode
                        && drone.capabilities().steering(mode.mode()).equals(Optional.of(Steering.MISSION)))) {
            return onBoard(drone);
        }
        return Route.NONE;
    }

    /**
     * Where a setpoint leads a drone within a short time, said as the command that leads there; empty when it leads nowhere, or
     * when sticks are moved and nobody knows where the drone is: without GPS they are what is left.
     */
    public static Optional<Command> ahead(DroneState drone, Setpoint setpoint) {
        return setpoint.isStill() ? Optional.empty() : new Lead(drone).of(setpoint);
    }

    /** Where a drone would go by itself later on, once it is called home. */
    static Route refuges(Command command) {
        if (command instanceof Command.SetHome home && home.point() != null) {
            return new Route(List.of(refuge("The new home", home.point())), null);
        }
        if (command instanceof Command.SetRallyPoints rally) {
            return new Route(
                    IntStream.range(0, rally.points().size())
                            .mapToObj(index -> refuge(
                                    "Rally point " + (index + 1),
                                    rally.points().get(index).point()))
                            .toList(),
                    null);
        }
        return Route.NONE;
    }

    private static Leg refuge(String words, Geodetic point) {
        return new Leg(words, point, point, new Heights(List.of(), true));
    }

    /** The way home and down, which is only warned of. */
    public static Route home(DroneState drone) {
        return new MissionWalk(drone).through(List.of(new MissionItem.ReturnToLaunch()), 0);
    }

    private static Route uploaded(DroneState drone, List<MissionItem> items) {
        MissionWalk walk = new MissionWalk(drone);
        boolean placed = drone.position() != null && drone.position().point() != null;
        return (placed || drone.airborne() ? walk : walk.fromAnywhere()).through(items, 0);
    }

    private static Route onBoard(DroneState drone) {
        MissionProgress mission = drone.mission();
        List<MissionItem> items = mission.items();
        if (items == null) {
            return new Route(List.of(), "Which mission is on the vehicle is not known");
        }
        Integer current = mission.current();
        boolean goesOn = drone.airborne() && !mission.complete() && current != null;
        return new MissionWalk(drone).through(items, goesOn ? current : 0);
    }
}
