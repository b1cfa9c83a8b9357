package org.dronemap.ws.dispatch;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.dispatch.DispatchInput;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationOwners;
import org.dronemap.ws.operation.PoolDroneSelector;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Finds another drone for each dispatch whose drone cannot come. What comes of that is the dispatch's own. One thread. */
public final class DispatchScheduler implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(DispatchScheduler.class);
    private static final Duration PAUSE = Duration.ofMillis(500);
    /** That much has to be in the battery of another one to stay. */
    private static final double LEAST_MINUTES = 3;

    private final Operations operations;
    private final OperationKind<DispatchState, DispatchInput> kind;
    private final PoolDroneSelector drones;
    private final DronePool pool;
    private final OperationOwners owners;
    private final Clock clock;
    private final Worker thread;

    public DispatchScheduler(
            DispatchService.OperationContext conduct, DronePool pool, OperationOwners owners, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.drones = new PoolDroneSelector(conduct.cloud());
        this.pool = pool;
        this.owners = owners;
        this.clock = time.clock();
        this.thread = time.worker("dispatches", 1);
    }

    /** Looks at all dispatches from now on. */
    public void start() {
        ScheduledTask begun = thread.every(PAUSE, PAUSE, this::check);
        LOG.debug("Looking for dispatches without a drone begins: {}", begun);
    }

    private void check() {
        for (Snapshot<DispatchState> dispatch : operations.underWay(kind)) {
            if (!dispatch.state().isSearching()) {
                continue;
            }
            try {
                Snapshot<DispatchState> unused =
                        operations.request(kind, dispatch.saved().id(), next(dispatch));
            } catch (Operations.Refused late) {
                LOG.debug("{} has changed meanwhile: {}", dispatch.saved().id(), late.why());
            } catch (RuntimeException e) {
                // It ends by itself when none is found for too long.
                LOG.warn(
                        "No other drone can be looked for now for {}",
                        dispatch.saved().id(),
                        e);
            }
        }
    }

    private DispatchInput next(Snapshot<DispatchState> dispatch) {
        Instant now = clock.instant().truncatedTo(ChronoUnit.MICROS);
        Optional<Principal> owner = owners.find(dispatch.saved().account());
        if (owner.isEmpty()) {
            return new DispatchInput.NoDroneAvailable(
                    now, dispatch.saved().owner() + " may not command drones any more.");
        }
        DispatchState state = dispatch.state();
        List<DroneState> candidates = DispatchService.candidates(drones, pool, owner.get()).stream()
                .filter(drone -> !state.failed().contains(drone.id()))
                .toList();
        PoolDroneSelector.Found found =
                drones.find(owner.get(), candidates, DispatchService.task(state.order(), LEAST_MINUTES), now);
        return found.chosen()
                .<DispatchInput>map(chosen -> new DispatchInput.SendDrone(now, chosen))
                .orElseGet(() -> new DispatchInput.NoDroneAvailable(
                        now, candidates.isEmpty() ? "The pool has no other drone for you." : found.why()));
    }

    @Override
    public void close() {
        thread.close();
    }
}
