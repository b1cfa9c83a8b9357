package org.dronemap.ws.log;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.ReadLogs;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;

/**
 * Lists the logs on board of a vehicle, downloads them to the server, and hands out or deletes the server's copies. Any
 * thread.
 */
public final class OnboardLogService {
    private final CloudManager cloud;
    private final DroneService drones;
    private final CommandService commands;
    private final OnboardLogArchive shelf;

    public OnboardLogService(
            CloudManager cloud, DroneService drones, CommandService commands, OnboardLogArchive shelf) {
        this.cloud = cloud;
        this.drones = drones;
        this.commands = commands;
        this.shelf = shelf;
    }

    /** As last listed. */
    public OnboardLogsView logs(Principal principal, String droneId) {
        DroneState drone = drones.state(principal, droneId);
        return new OnboardLogsView(Optional.ofNullable(cloud.onBoard(drone.id()).logs())
                .map(logs -> logs.stream().map(log -> view(drone, log)).toList())
                .orElse(null));
    }

    private OnboardLogsView.LogView view(DroneState drone, VehicleLog log) {
        return new OnboardLogsView.LogView(
                log.number(),
                log.at(),
                log.sizeBytes(),
                shelf.find(drone.id(), log).isPresent());
    }

    public CommandView refresh(Caller caller, String droneId) {
        return commands.give(
                caller.principal(),
                caller.face(),
                drones.state(caller.principal(), droneId, Role.OPERATOR),
                null,
                new ReadLogs());
    }

    /** Goes on where an earlier attempt ended. */
    public CommandView download(Caller caller, String droneId, int number) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.OPERATOR);
        VehicleLog log = log(drone, number);
        if (shelf.find(drone.id(), log).isPresent()) {
            throw Rejection.of(
                    DroneProblem.LOG_FETCHED,
                    "The server has this log already; save the file, or remove it to fetch it anew.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        return commands.give(
                caller.principal(),
                caller.face(),
                drone,
                null,
                new Command.DownloadLog(log, shelf.open(drone.id(), log)));
    }

    public Path file(Principal principal, String droneId, int number) {
        DroneState drone = drones.state(principal, droneId);
        return shelf.find(drone.id(), log(drone, number))
                .orElseThrow(() -> Rejection.of(
                        DroneProblem.LOG_NOT_FETCHED,
                        "This log has not been fetched from the vehicle yet.",
                        ProblemParameter.DRONE.is(drone.id().value())));
    }

    /** Removes the server's copy; the vehicle keeps its own. */
    public void remove(Caller caller, String droneId, int number) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.OPERATOR);
        if (!shelf.remove(drone.id(), log(drone, number))) {
            throw Rejection.of(
                    DroneProblem.LOG_NOT_FETCHED,
                    "The server has no copy of this log.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
    }

    private VehicleLog log(DroneState drone, int number) {
        List<VehicleLog> logs = Optional.ofNullable(cloud.onBoard(drone.id()).logs())
                .orElseThrow(() -> Rejection.of(
                        DroneProblem.LOGS_NOT_LISTED,
                        "The logs of this drone have not been listed yet; refresh them first.",
                        ProblemParameter.DRONE.is(drone.id().value())));
        return logs.stream()
                .filter(log -> log.number() == number)
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.LOG, Integer.toString(number)));
    }
}
