package org.dronemap.ws.service;

import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;

/** Use cases around the fence and the rally points that a vehicle keeps: read, replace, take away. Any thread. */
public final class FenceService {
    private final CloudManager cloud;
    private final DroneService drones;
    private final CommandService commands;

    public FenceService(CloudManager cloud, DroneService drones, CommandService commands) {
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
        return give(caller, droneId, new Command.ReadFence());
    }

    public CommandView readRallyPoints(Caller caller, String droneId) {
        return give(caller, droneId, new Command.ReadRallyPoints());
    }

    public CommandView setFence(Caller caller, String droneId, FenceView fence) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.PLANNER);
        return give(caller, drone, new Command.SetFence(FenceReader.fence(fence)));
    }

    public CommandView setRallyPoints(Caller caller, String droneId, FenceView.RallyView points) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.PLANNER);
        return give(caller, drone, new Command.SetRallyPoints(FenceReader.rally(points)));
    }

    public CommandView clearFence(Caller caller, String droneId) {
        return give(caller, droneId, new Command.SetFence(List.of()));
    }

    public CommandView clearRallyPoints(Caller caller, String droneId) {
        return give(caller, droneId, new Command.SetRallyPoints(List.of()));
    }

    private CommandView give(Caller caller, String droneId, Command command) {
        return give(caller, drones.state(caller.principal(), droneId, Role.PLANNER), command);
    }

    private CommandView give(Caller caller, DroneState drone, Command command) {
        return commands.give(caller.principal(), caller.face(), drone, null, command);
    }
}
