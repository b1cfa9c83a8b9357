package org.dronemap.ws.run;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.plan.PlanBarriers;
import org.dronemap.ws.schedule.PeriodicTask;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports zones made since planning to mission runs, so that they re-plan around them before a drone is stopped. One
 * thread at a time.
 */
public final class RunZoneSynchronizer {
    private static final Logger LOG = LoggerFactory.getLogger(RunZoneSynchronizer.class);

    private static final Duration RHYTHM = Duration.ofMillis(500);

    private final Operations operations;
    private final OperationKind<RunState, RunInput> kind;
    private final ZoneRegistry book;
    private final Clock clock;
    /** Not to be told again. */
    private final Set<Notice> refused = new HashSet<>();

    private record Notice(OperationId run, Barrier barrier) {}

    private RunZoneSynchronizer(RunService.OperationContext context, Clock clock) {
        this.operations = context.operations();
        this.kind = context.kind();
        this.book = context.cloud().zones();
        this.clock = clock;
    }

    /** Synchronizes all runs twice a second, until it is closed. */
    public static PeriodicTask start(RunService.OperationContext context, Time time) {
        RunZoneSynchronizer zones = new RunZoneSynchronizer(context, time.clock());
        return new PeriodicTask(
                time,
                "run-zones",
                RHYTHM,
                zones::synchronize,
                "Not every mission run could be told of the zones; it is tried again");
    }

    /** Compares what binds now with what each run keeps to, so that it does not matter when, and over which restart, it came. */
    private void synchronize() {
        List<Snapshot<RunState>> runs = operations.underWay(kind);
        refused.removeIf(one -> runs.stream().noneMatch(run -> run.saved().id().equals(one.run())));
        runs.forEach(this::synchronize);
    }

    private void synchronize(Snapshot<RunState> run) {
        RunState state = run.state();
        Instant now = clock.instant().truncatedTo(ChronoUnit.MICROS);
        List<Barrier> binding = PlanBarriers.of(
                run.saved().owner(),
                book,
                state.targets().stream().map(RunWaypoint::waypoint).toList(),
                state.drones().stream().map(RunDrone::craft).toList(),
                now);
        for (Barrier barrier : binding) {
            Notice notice = new Notice(run.saved().id(), barrier);
            boolean isKept = state.setting().barriers().stream().anyMatch(kept -> covers(kept, barrier));
            if (!isKept && !refused.contains(notice)) {
                deliver(notice, new RunInput.AddBarrier(now, author(barrier), barrier));
            }
        }
    }

    private void deliver(Notice notice, RunInput.AddBarrier input) {
        try {
            operations.request(kind, notice.run(), input);
        } catch (Operations.Refused e) {
            refused.add(notice);
            LOG.warn(
                    "The mission run {} does not plan round {}: {}",
                    notice.run(),
                    notice.barrier().words(),
                    e.why());
        }
    }

    private static boolean covers(Barrier kept, Barrier barrier) {
        boolean bindsAll = kept.drones().isEmpty()
                || (!barrier.drones().isEmpty() && kept.drones().containsAll(barrier.drones()));
        return bindsAll
                && kept.words().equals(barrier.words())
                && kept.shape().equals(barrier.shape())
                && kept.band().equals(barrier.band());
    }

    private String author(Barrier barrier) {
        return book.zones().stream()
                .filter(zone ->
                        zone.words().equals(barrier.words()) && zone.shape().equals(barrier.shape()))
                .map(Zone::changedBy)
                .findFirst()
                .orElse("Somebody");
    }
}
