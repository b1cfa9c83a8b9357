package org.dronemap.ws.command;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.OutageClassifier;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Gives one command to several drones or to all of them, as a separate command for each that is checked as any other.
 * Any thread.
 */
public final class BroadcastService {
    private static final String ALL = "all";
    private static final String DRONES_FORM = "\"all\" or a list of 1 to 1000 ids of drones";
    private static final String ID_FORM = "8 to 36 of A-Z, a-z, 0-9, _ and -";
    static final String ID = "^[A-Za-z0-9_-]{8,36}$";
    static final int MOST_DRONES = 1_000;
    private static final int LONGEST_COMMAND_ID = 64;

    private final CloudManager cloud;
    private final CommandService commands;

    public BroadcastService(CloudManager cloud, CommandService commands) {
        this.cloud = cloud;
        this.commands = commands;
    }

    /** Checks what holds for all, then asks the gate for each; what one drone cannot do keeps no other from it. */
    public BroadcastView submit(Principal principal, String face, BroadcastRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        CommandRequest command = request.command();
        if (command == null) {
            throw InvalidInput.missing("command", "a command such as {\"type\":\"land\"}");
        }
        if (command.id() != null) {
            throw new InvalidInput(
                    ValueProblem.VALUE_NOT_ALLOWED,
                    "command.id",
                    "left out",
                    "The id of a command for several stands beside it.");
        }
        commands.pay(principal, command);
        String id = id(request.id());
        List<String> targets = targets(principal, request.drones());
        checkForAll(principal, targets, command);
        if (request.id() != null) {
            known(principal, targets)
                    .forEach(drone ->
                            commands.checkId(principal, idFor(id, drone.id().value()), command, drone));
        }
        List<BroadcastView.Result> results = new ArrayList<>();
        for (String drone : targets) {
            results.add(one(principal, face, drone, idFor(id, drone), command));
        }
        return new BroadcastView(id, List.copyOf(results));
    }

    private BroadcastView.Result one(
            Principal principal, String face, String drone, String id, CommandRequest command) {
        String name = commands.nameOf(principal, drone);
        try {
            return BroadcastView.Result.given(drone, name, commands.submitPaid(principal, face, drone, id, command));
        } catch (Rejection rejection) {
            String refused = rejection.commandId();
            return refused == null
                    ? BroadcastView.Result.refused(drone, name, rejection)
                    : BroadcastView.Result.given(drone, name, commands.command(principal, refused));
        } catch (RuntimeException failed) {
            return BroadcastView.Result.refused(drone, name, OutageClassifier.rejectionOf(failed));
        }
    }

    /** A value that no drone can take is refused before anything is sent to any. */
    private void checkForAll(Principal principal, List<String> targets, CommandRequest command) {
        known(principal, targets).findFirst().ifPresent(drone -> {
            try {
                commands.check(command, drone);
            } catch (InvalidInput wrong) {
                throw wrong.within("command.");
            }
        });
    }

    private Stream<DroneState> known(Principal principal, List<String> targets) {
        return targets.stream().flatMap(drone -> commands.known(principal, drone).stream());
    }

    private List<String> targets(Principal principal, @Nullable List<@Nullable String> asked) {
        if (asked == null || asked.isEmpty()) {
            throw InvalidInput.missing("drones", DRONES_FORM);
        }
        if (asked.size() == 1 && ALL.equals(asked.get(0))) {
            return cloud.drones().stream()
                    .filter(drone -> !drone.replay() && principal.sees(drone.id()))
                    .map(DroneState::id)
                    .map(id -> id.value())
                    .toList();
        }
        Set<String> each = new LinkedHashSet<>();
        for (String drone : asked) {
            if (drone == null) {
                throw InvalidInput.outside(
                        ValueProblem.VALUE_MALFORMED, "drones", DRONES_FORM, "a list with null in it");
            }
            each.add(drone);
        }
        if (each.size() > MOST_DRONES) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "drones",
                    DRONES_FORM,
                    each.size() + " ids",
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_DRONES));
        }
        return List.copyOf(each);
    }

    /** The whole once every command has ended, or as it stands when the wait is over. */
    public CompletableFuture<BroadcastView> awaitEnd(BroadcastView broadcast, Duration wait) {
        List<CompletableFuture<BroadcastView.Result>> ends = broadcast.results().stream()
                .map(result -> {
                    CommandView command = result.command();
                    return command == null
                            ? CompletableFuture.completedFuture(result)
                            : commands.awaitEnd(command, wait)
                                    .thenApply(
                                            ended -> BroadcastView.Result.given(result.drone(), result.name(), ended));
                })
                .toList();
        return CompletableFuture.allOf(ends.toArray(CompletableFuture[]::new))
                .thenApply(all -> new BroadcastView(
                        broadcast.id(),
                        ends.stream().map(CompletableFuture::join).toList()));
    }

    private String id(@Nullable String given) {
        if (given == null) {
            return "all-" + commands.newId().substring(0, 18);
        }
        if (!given.matches(ID)) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "id", ID_FORM, "\"" + given + "\"");
        }
        return given;
    }

    /** The same for the same drone whenever it is asked, so that repeating acts once. */
    private static String idFor(String id, String drone) {
        String whole = id + "-" + drone.replaceAll("[^A-Za-z0-9_-]", "_");
        if (whole.length() <= LONGEST_COMMAND_ID) {
            return whole;
        }
        // Drones whose names begin alike keep ids of their own.
        UUID rest = UUID.nameUUIDFromBytes(drone.getBytes(StandardCharsets.UTF_8));
        return id + "-" + rest.toString().replace("-", "").substring(0, 27);
    }
}
