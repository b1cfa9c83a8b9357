package org.dronemap.ws.parameter;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterComparison;
import org.dronemap.core.parameter.ParameterFile;
import org.dronemap.core.parameter.ParameterFileContent;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.command.ParameterReader;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Lists, refreshes and sets the parameters on board of a vehicle, and saves, compares and loads parameter files. Any
 * thread.
 */
public final class ParameterService {
    private static final String FORMS = "list or table";

    private final CloudManager cloud;
    private final DroneService drones;
    private final CommandService commands;

    /** {@code id}: the client's own; the same twice acts once. */
    @Schema(name = "ParameterValueRequest")
    public record ValueRequest(
            @Nullable Double value, @Nullable String id) {}

    public ParameterService(CloudManager cloud, DroneService drones, CommandService commands) {
        this.cloud = cloud;
        this.drones = drones;
        this.commands = commands;
    }

    /** As last heard; those whose name has all the words in it, all when there are none. */
    public ParametersView parameters(Principal principal, String droneId, @Nullable String search) {
        ParameterSet all = held(drones.state(principal, droneId));
        List<Parameter> found = search == null ? all.all() : all.search(search);
        return new ParametersView(
                all.readAt() == null ? null : all.readAt().truncatedTo(ChronoUnit.MILLIS),
                all.size(),
                found.stream().map(ParametersView.ParameterView::of).toList());
    }

    public CommandView refresh(Caller caller, String droneId) {
        return commands.give(
                caller.principal(),
                caller.face(),
                drones.state(caller.principal(), droneId, Role.OPERATOR),
                null,
                new Command.ReadParameters());
    }

    public CommandView set(Caller caller, String droneId, String name, ValueRequest request) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.OPERATOR);
        Command change = new Command.SetParameters(
                List.of(ParameterReader.checked("name", name, "value", request.value(), held(drone))));
        return commands.give(caller.principal(), caller.face(), drone, request.id(), change);
    }

    /** A file for ground stations. */
    public String file(Principal principal, String droneId, @Nullable String form) {
        DroneState drone = drones.state(principal, droneId);
        return ParameterFile.write(
                whole(drone).all(), form(form), drone.link().key().systemId());
    }

    private static ParameterFile.Form form(@Nullable String form) {
        return switch (form == null ? "list" : form) {
            case "list" -> ParameterFile.Form.LIST;
            case "table" -> ParameterFile.Form.TABLE;
            default -> throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "form", FORMS, "\"" + form + "\"");
        };
    }

    /** What a file would change; nothing is sent. */
    public ParametersView.FileView compare(Caller caller, String droneId, String text) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.OPERATOR);
        ParameterSet held = whole(drone);
        ParameterFileContent file = ParameterReader.file(text);
        return ParametersView.FileView.of(ParameterComparison.of(held, file.values()), file.leftOut(), null);
    }

    /** Changes what is otherwise in the file. */
    public ParametersView.FileView load(Caller caller, String droneId, String text) {
        DroneState drone = drones.state(caller.principal(), droneId, Role.OPERATOR);
        ParameterSet held = whole(drone);
        ParameterFileContent file = ParameterReader.file(text);
        ParameterComparison comparison = ParameterComparison.of(held, file.values());
        CommandView command = comparison.different().isEmpty()
                ? null
                : commands.give(
                        caller.principal(),
                        caller.face(),
                        drone,
                        null,
                        new Command.SetParameters(comparison.changes()));
        return ParametersView.FileView.of(comparison, file.leftOut(), command);
    }

    private ParameterSet whole(DroneState drone) {
        ParameterSet all = held(drone);
        if (all.readAt() == null) {
            throw Rejection.of(
                    DroneProblem.PARAMETERS_NOT_READ,
                    "The parameters of this drone have not been read yet; refresh them first.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        return all;
    }

    private ParameterSet held(DroneState drone) {
        return cloud.onBoard(drone.id()).parameters();
    }
}
