package org.dronemap.ws.fence;

import java.time.Clock;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.ReadFence;
import org.dronemap.core.command.ReadRallyPoints;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.zone.VehicleFence;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;

/** Reads, replaces and clears the geofence and rally points stored on board of a vehicle, for users. Any thread. */
public final class FenceService {
    private final CloudManager cloud;
    private final DroneService drones;
    private final CommandService commands;
    private final Clock clock;

    public FenceService(CloudManager cloud, DroneService drones, CommandService commands, Clock clock) {
        this.clock = clock;
        this.cloud = cloud;
        this.drones = drones;
        this.commands = commands;
    }

    /** As last read. */
    public FenceView fence(Principal principal, String droneId) {
        return FenceView.of(cloud.onBoard(drones.state(principal, droneId).id()).fence());
    }

    /** As last read. */
    public FenceView.RallyView rallyPoints(Principal principal, String droneId) {
        return FenceView.RallyView.of(
                cloud.onBoard(drones.state(principal, droneId).id()).rallyPoints());
    }

    public CommandView readFence(Caller caller, String droneId) {
        return give(caller, droneId, new ReadFence());
    }

    public CommandView readRallyPoints(Caller caller, String droneId) {
        return give(caller, droneId, new ReadRallyPoints());
    }

    public CommandView setFence(Caller caller, String droneId, FenceView fence) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.PLANNER);
        return give(caller, drone, FenceReader.fence(fence));
    }

    /** Makes the zones that bind a drone its own fence; those that it cannot keep are told as warnings. */
    public CommandView putZonesOnBoard(Caller caller, String droneId) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.PLANNER);
        VehicleFence fence = VehicleFence.of(cloud.zones(), drone.id(), clock.instant());
        if (fence.shapes().isEmpty()) {
            throw Rejection.of(
                    DroneProblem.NO_ZONE_FOR_FENCE,
                    "No zone without floor and ceiling binds this drone now; its fence stays as it is.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        if (fence.shapes().size() > SetFence.MOST_PARTS) {
            throw Rejection.of(
                    DroneProblem.FENCE_FULL,
                    fence.shapes().size() + " zones bind this drone now; a vehicle keeps " + SetFence.MOST_PARTS
                            + " at most. Its fence stays as it is.",
                    ProblemParameter.DRONE.is(drone.id().value()),
                    ProblemParameter.COUNT.is(fence.shapes().size()),
                    ProblemParameter.MOST.is(SetFence.MOST_PARTS));
        }
        List<String> leftOut = fence.leftOut().stream()
                .map(zone -> "Not on board is " + zone.words() + ": vehicles know no floor and no ceiling.")
                .toList();
        return give(caller, drone, new SetFence(fence.shapes())).warned(leftOut);
    }

    public CommandView setRallyPoints(Caller caller, String droneId, FenceView.RallyView points) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.PLANNER);
        return give(caller, drone, new SetRallyPoints(FenceReader.rally(points)));
    }

    public CommandView clearFence(Caller caller, String droneId) {
        return give(caller, droneId, new SetFence(List.of()));
    }

    public CommandView clearRallyPoints(Caller caller, String droneId) {
        return give(caller, droneId, new SetRallyPoints(List.of()));
    }

    private CommandView give(Caller caller, String droneId, Command command) {
        return give(caller, drones.state(caller.principal(), droneId, Role.PLANNER), command);
    }

    private CommandView give(Caller caller, DroneState drone, Command command) {
        return commands.give(caller.principal(), caller.face(), drone, null, command);
    }
}
