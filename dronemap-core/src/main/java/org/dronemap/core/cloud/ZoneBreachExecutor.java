package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Commands the action of a breached zone (hold, return, land), on a thread of its own. Tried again while it fails, a
 * few times.
 */
final class ZoneBreachExecutor {
    /** The way in that commands of the zones come by. */
    static final String FACE = "safety";

    private static final Logger LOG = LoggerFactory.getLogger(ZoneBreachExecutor.class);
    private static final CommandGate.Source SOURCE =
            new CommandGate.Source(new Principal("zones", Role.SUPERVISOR), FACE);
    private static final int TRIES = 4;
    private static final Duration PAUSE = Duration.ofSeconds(1);
    /** A breach of each of very many drones at once. */
    private static final int CAPACITY = 100_000;

    private final DroneRegistry registry;
    private final CommandGate gate;
    private final Time time;
    private final Worker thread;

    ZoneBreachExecutor(DroneRegistry registry, CommandGate gate, Time time) {
        this.registry = registry;
        this.gate = gate;
        this.time = time;
        this.thread = time.worker("zones", CAPACITY);
    }

    Optional<DroneState> state(DroneId id) {
        return registry.find(id).map(managed -> managed.drone().state());
    }

    /** A sentence for everybody who looks at the drone. */
    void publishMessage(DroneId id, Severity severity, String sentence) {
        registry.find(id).ifPresent(drone -> {
            try {
                drone.lane().execute(() -> drone.publishMessage(severity, sentence));
            } catch (RejectedExecutionException e) {
                LOG.warn("Not said of {}: {}", id, sentence);
            }
        });
    }

    void breached(DroneState state, Zone zone) {
        String what = zone.shape().inside() ? "It has left " : "It has entered ";
        if (state.capabilities().isSafe(state.mode())) {
            publishMessage(
                    state.id(), Severity.CRITICAL, what + zone.words() + "; it is on its way home or down already.");
            return;
        }
        Command command = command(state, zone.onBreach());
        publishMessage(state.id(), Severity.CRITICAL, what + zone.words() + " and is told: " + command.summary() + ".");
        thread.execute(() -> act(state.id(), command, TRIES));
    }

    /**
     * Whoever took it out of what it was told answers for it, as long as it waits for orders or a pilot steers; what flies its
     * own way or a mission is told once more.
     */
    void stillBreached(DroneState state, Zone zone) {
        Optional<Steering> steering = state.capabilities().steering(state.mode());
        if (state.capabilities().isSafe(state.mode())) {
            return;
        }
        String where = (zone.shape().inside() ? "It is still outside of " : "It is still in ") + zone.words();
        if (steering.filter(Steering::waitsForSomebody).isPresent()) {
            publishMessage(state.id(), Severity.CRITICAL, where + "; fly it out, or call it home.");
            return;
        }
        Command command = command(state, zone.onBreach());
        publishMessage(state.id(), Severity.CRITICAL, where + " and is told again: " + command.summary() + ".");
        thread.execute(() -> act(state.id(), command, TRIES));
    }

    /** What is asked for, or else the next best thing that the vehicle can do. */
    private static Command command(DroneState state, BreachAction wanted) {
        Command first = command(wanted);
        return Stream.concat(
                        Stream.of(first),
                        Stream.of(new Command.Hold(), new Command.ReturnToLaunch(), new Command.Land()))
                .filter(command -> state.capabilities().commands().contains(command.needs()))
                .findFirst()
                .orElse(first);
    }

    private static Command command(BreachAction action) {
        return switch (action) {
            case HOLD -> new Command.Hold();
            case RETURN_TO_LAUNCH -> new Command.ReturnToLaunch();
            case LAND -> new Command.Land();
        };
    }

    private void act(DroneId drone, Command command, int tries) {
        try {
            CommandRecord record = gate.submit(SOURCE, drone, new CommandId(time.newId()), command);
            CompletableFuture<Void> unused = gate.end(record.id()).thenAccept(ended -> judge(ended, command, tries));
        } catch (UnknownDroneException removedMeanwhile) {
            LOG.info("{} was removed before it could be told to {}", drone, command.summary());
        } catch (RuntimeException e) {
            LOG.error("{} could not be told to {}", drone, command.summary(), e);
            again(drone, command, tries, "the server could not send it");
        }
    }

    private void judge(CommandRecord ended, Command command, int tries) {
        Outcome outcome = ended.outcome();
        if (outcome == null) {
            return;
        }
        switch (outcome.kind()) {
            case SUCCEEDED, SUPERSEDED -> {}
            case REFUSED, FAILED, TIMED_OUT, UNKNOWN -> again(ended.drone(), command, tries, outcome.toString());
        }
    }

    private void again(DroneId drone, Command command, int tries, String why) {
        boolean stillFlies = state(drone).filter(DroneState::airborne).isPresent();
        if (!stillFlies) {
            return;
        }
        if (tries <= 1) {
            publishMessage(drone, Severity.ALERT, "It could not be told to " + command.summary() + "; take over.");
            return;
        }
        LOG.warn("{} was told to {} without success ({}); once more", drone, command.summary(), why);
        ScheduledTask unused = thread.after(PAUSE, () -> act(drone, command, tries - 1));
    }
}
