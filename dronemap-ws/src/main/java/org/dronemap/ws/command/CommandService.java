package org.dronemap.ws.command;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionWarnings;
import org.dronemap.core.time.Time;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.history.NameRedaction;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Submits commands of users to drones for all faces: checks them, charges budgets and hands them to the cloud manager.
 * Any thread.
 */
public final class CommandService {
    static final String ID = "^[A-Za-z0-9_-]{8,64}$";
    private static final String ID_FORM = "8 to 64 of A-Z, a-z, 0-9, _ and -";
    private static final int MOST_SHOWN = 50;
    private final CloudManager cloud;
    private final DroneService drones;
    private final Budgets budgets;
    private final Time time;

    public CommandService(CloudManager cloud, DroneService drones, Budgets budgets, Time time) {
        this.cloud = cloud;
        this.drones = drones;
        this.budgets = budgets;
        this.time = time;
    }

    /** Checks everything, then asks the gate; the answer is under way, or ended when the id is an old one. */
    public CommandView submit(Principal principal, String face, String droneId, CommandRequest request) {
        pay(principal, request);
        return submitPaid(principal, face, droneId, request.id(), request);
    }

    /** What is for safety costs nothing, however much somebody asked for before. */
    void pay(Principal principal, CommandRequest request) {
        if (!isForSafety(request)) {
            budgets.charge(WorkKind.COMMAND, principal.name());
        }
    }

    /** As {@link #submit}, when it was paid for; {@code givenId} stands in place of the request's own. */
    CommandView submitPaid(
            Principal principal, String face, String droneId, @Nullable String givenId, CommandRequest request) {
        // Which commands these are is the gate's to say, and written down.
        DroneState drone = drones.state(principal, droneId, Role.OPERATOR, Role.PLANNER);
        Command asked = asked(request, drone);
        CommandGate.Source source = new CommandGate.Source(principal, face, request.epoch());
        return give(source, drone, givenId, asked).warned(warnings(CommandReader.complete(asked, drone), drone));
    }

    private Command asked(CommandRequest request, DroneState drone) {
        return request.command(drone, cloud.onBoard(drone.id()).parameters());
    }

    /** Refuses what this drone cannot take; nothing is sent. */
    void check(CommandRequest request, DroneState drone) {
        CommandReader.complete(asked(request, drone), drone);
    }

    /** Refuses an id that another command has; nothing is sent. What is for safety waits for no store. */
    void checkId(Principal principal, String givenId, CommandRequest request, DroneState drone) {
        if (!isForSafety(request)) {
            cloud.gate()
                    .find(id(givenId))
                    .ifPresent(record -> requireSame(record, principal, drone, asked(request, drone)));
        }
    }

    private static boolean isForSafety(CommandRequest request) {
        return request.kind().purpose().interrupts();
    }

    /** Nothing of it is refused: programs may mean what they say, and the page asks people before. */
    private static List<String> warnings(Command command, DroneState drone) {
        Position position = drone.position();
        Geodetic from = position == null ? null : position.point();
        if (command instanceof Command.UploadMission upload) {
            return MissionWarnings.about(upload.mission(), from);
        }
        return command instanceof Command.GoTo goTo ? MissionWarnings.about(goTo.point(), from) : List.of();
    }

    /** Gives a checked command; {@code givenId} is the client's own. */
    public CommandView give(
            Principal principal, String face, DroneState drone, @Nullable String givenId, Command command) {
        budgets.charge(WorkKind.COMMAND, principal.name());
        return give(new CommandGate.Source(principal, face), drone, givenId, command);
    }

    private CommandView give(CommandGate.Source source, DroneState drone, @Nullable String givenId, Command asked) {
        CommandId id = id(givenId);
        CommandRecord record = ask(source, drone, id, asked);
        requireSame(record, source.principal(), drone, asked);
        if (record.outcome() instanceof Outcome.Refused refused && refused.by().equals("gate")) {
            throw Rejection.refused(
                    new Refusal(refused.code(), refused.reason()),
                    drone.id(),
                    id.value(),
                    cloud.controls().control(drone.id()));
        }
        return CommandView.of(record);
    }

    /** What was said of the same again is no new command; whatever else has its id is. */
    private static void requireSame(CommandRecord record, Principal principal, DroneState drone, Command asked) {
        if (!record.isOf(
                principal.name(), principal.account(), drone.id(), CommandReader.complete(asked, drone), asked)) {
            String which = principal.sight(record.drone(), record.at()) != VisibilityLevel.NONE
                    ? " (" + record.summary() + ")"
                    : "";
            throw Rejection.of(
                    DroneProblem.COMMAND_ID_TAKEN,
                    "The id " + record.id() + " belongs to another command already" + which + "; take a new one.",
                    ProblemParameter.COMMAND.is(record.id().value()));
        }
    }

    private CommandRecord ask(CommandGate.Source source, DroneState drone, CommandId id, Command asked) {
        try {
            return cloud.gate().submit(source, drone.id(), id, CommandReader.complete(asked, drone), asked);
        } catch (UnknownDroneException removedMeanwhile) {
            throw Rejection.unknown(NotFoundProblem.DRONE, drone.id().value());
        }
    }

    /** The command once it has ended, or as it stands when the wait is over. */
    public CompletableFuture<CommandView> awaitEnd(CommandView command, Duration wait) {
        CommandId id = new CommandId(command.id());
        return time.within(
                        cloud.gate().end(id).<Optional<CommandRecord>>thenApply(Optional::of), wait, Optional.empty())
                .thenApply(ended -> ended.or(() -> cloud.gate().find(id))
                        .map(record -> CommandView.of(record).warned(command.warnings()))
                        .orElse(command));
    }

    /** The command once it has ended, or as it stands when there was no news of it for so long (twice as long at most). */
    public CompletableFuture<CommandView> awaitEndOrSilence(CommandView command, Duration silence) {
        return awaitEndOrSilence(command, now -> awaitEnd(now, silence));
    }

    /** The same where one silence is as long as that function says. */
    public static CompletableFuture<CommandView> awaitEndOrSilence(
            CommandView command, Function<CommandView, CompletableFuture<CommandView>> silence) {
        return silence.apply(command)
                .thenCompose(now -> now.outcome() != null || now.equals(command)
                        ? CompletableFuture.completedFuture(now)
                        : awaitEndOrSilence(now, silence));
    }

    public CommandView command(Principal principal, String id) {
        return Optional.of(id)
                .filter(CommandService::isId)
                .flatMap(text -> cloud.gate().find(new CommandId(text)))
                .flatMap(record -> shown(principal, record))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.COMMAND, id));
    }

    /** Newest first. */
    public List<CommandView> commandsOf(Principal principal, String droneId) {
        return cloud.gate().commandsOf(drones.state(principal, droneId).id(), MOST_SHOWN).stream()
                .flatMap(record -> shown(principal, record).stream())
                .toList();
    }

    private static Optional<CommandView> shown(Principal principal, CommandRecord record) {
        CommandView view = CommandView.of(record);
        return switch (principal.sight(record.drone(), record.at())) {
            case NONE -> Optional.empty();
            case WITHOUT_NAMES -> Optional.of(view.withoutNames(NameRedaction.OTHERS));
            case ALL -> Optional.of(view);
        };
    }

    public Optional<DroneState> known(Principal principal, String droneId) {
        return drones.find(principal, droneId);
    }

    @Nullable
    String nameOf(Principal principal, String droneId) {
        return drones.find(principal, droneId).map(DroneState::name).orElse(null);
    }

    String newId() {
        return time.newId();
    }

    private CommandId id(@Nullable String given) {
        if (given == null) {
            return new CommandId(newId());
        }
        if (!isId(given)) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "id", ID_FORM, "\"" + given + "\"");
        }
        return new CommandId(given);
    }

    private static boolean isId(String text) {
        return text.matches(ID);
    }
}
