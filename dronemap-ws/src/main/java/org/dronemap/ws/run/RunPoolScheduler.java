package org.dronemap.ws.run;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.access.Principal;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.time.Time;
import org.dronemap.ws.operation.OperationOwners;
import org.dronemap.ws.plan.PlanDroneFactory;
import org.dronemap.ws.plan.PoolPlanDrones;
import org.dronemap.ws.schedule.PeriodicTask;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Lets another drone of the pool join each mission run that has lost one of those that the cloud chose. One thread. */
public final class RunPoolScheduler {
    private static final Logger LOG = LoggerFactory.getLogger(RunPoolScheduler.class);
    private static final Duration RHYTHM = Duration.ofSeconds(1);
    private static final String CLOUD = "The cloud";

    private final Operations operations;
    private final OperationKind<RunState, RunInput> kind;
    private final PoolPlanDrones pool;
    private final OperationOwners owners;
    private final Clock clock;

    private RunPoolScheduler(
            RunService.OperationContext context, PoolPlanDrones pool, OperationOwners owners, Clock clock) {
        this.operations = context.operations();
        this.kind = context.kind();
        this.pool = pool;
        this.owners = owners;
        this.clock = clock;
    }

    /** Looks at all runs once a second, until it is closed. */
    public static PeriodicTask start(
            RunService.OperationContext context, PoolPlanDrones pool, OperationOwners owners, Time time) {
        RunPoolScheduler scheduler = new RunPoolScheduler(context, pool, owners, time.clock());
        return new PeriodicTask(
                time,
                "run-pool",
                RHYTHM,
                scheduler::check,
                "Not every mission run could be given another drone of the pool; it is tried again");
    }

    private void check() {
        operations.underWay(kind).stream()
                .filter(run -> run.state().vacancies() > 0)
                .forEach(this::fill);
    }

    /** One at a time: the next one is looked for when this one counts. */
    private void fill(Snapshot<RunState> run) {
        Instant now = clock.instant().truncatedTo(ChronoUnit.MICROS);
        try {
            Snapshot<RunState> unused = operations.request(kind, run.saved().id(), next(run, now));
        } catch (Operations.Refused late) {
            LOG.debug("{} has changed meanwhile: {}", run.saved().id(), late.why());
        }
    }

    private RunInput next(Snapshot<RunState> run, Instant now) {
        Optional<Principal> owner = owners.find(run.saved().account());
        if (owner.isEmpty()) {
            return new RunInput.NoPoolDrone(now, CLOUD, run.saved().owner() + " may not command drones any more.");
        }
        RunState state = run.state();
        Set<DroneId> members = state.drones().stream().map(RunDrone::id).collect(Collectors.toSet());
        List<Geodetic> open = state.targets().stream()
                .filter(target -> !target.state().isSettled())
                .map(target -> target.waypoint().place().point())
                .toList();
        PoolPlanDrones.Found found = pool.find(owner.get(), 1, open, members);
        if (found.chosen().isEmpty()) {
            return new RunInput.NoPoolDrone(now, CLOUD, found.why());
        }
        DroneState drone = found.chosen().get(0);
        return new RunInput.JoinFromPool(
                now,
                CLOUD,
                PlanDroneFactory.of(drone),
                drone.name(),
                drone.identification().kind(),
                why(state));
    }

    private static String why(RunState state) {
        return state.drones().stream()
                .filter(drone -> !drone.stage().acceptsCommands())
                .map(RunDrone::note)
                .filter(Objects::nonNull)
                .collect(Collectors.joining(" "));
    }
}
