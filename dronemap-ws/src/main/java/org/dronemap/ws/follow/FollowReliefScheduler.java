package org.dronemap.ws.follow;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowStage;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationOwners;
import org.dronemap.ws.operation.PoolDroneSelector;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds a relief drone for each follow whose drone runs low on battery, early enough to arrive in time. What comes of
 * that is the follow's own. One thread.
 */
public final class FollowReliefScheduler implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(FollowReliefScheduler.class);
    private static final Duration PAUSE = Duration.ofSeconds(1);

    /** Nothing is so far away that it is looked for earlier. */
    private static final double EARLIEST_SECONDS = 600;
    /** Nobody is told earlier that none can come: one may be free by then. */
    private static final double TOLD_SECONDS = 180;
    /** That much has to be in another one's battery to stay. */
    private static final double LEAST_MINUTES = 5;

    /** Ways are longer than they are reckoned, and percentages coarse. */
    private static final double LONGER = 1.3;

    private static final double SPARE_SECONDS = 45;

    private final Operations operations;
    private final OperationKind<FollowState, FollowInput> kind;
    private final CloudManager cloud;
    private final PoolDroneSelector drones;
    private final DronePool warehouse;
    private final OperationOwners owners;
    private final Clock clock;
    private final Map<OperationId, String> troubles = new HashMap<>();
    private final Worker thread;

    public FollowReliefScheduler(
            FollowService.OperationContext conduct, DronePool warehouse, OperationOwners owners, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.cloud = conduct.cloud();
        this.drones = new PoolDroneSelector(conduct.cloud());
        this.warehouse = warehouse;
        this.owners = owners;
        this.clock = time.clock();
        this.thread = time.worker("follow-reliefs", 1);
    }

    /** Looks at all follows from now on. */
    public void start() {
        ScheduledTask begun = thread.every(PAUSE, PAUSE, this::check);
        LOG.debug("Looking for drones that run low begins: {}", begun);
    }

    private void check() {
        List<Snapshot<FollowState>> all = operations.underWay(kind);
        troubles.keySet()
                .retainAll(all.stream().map(follow -> follow.saved().id()).collect(Collectors.toSet()));
        for (Snapshot<FollowState> follow : all) {
            try {
                check(follow);
                troubles.remove(follow.saved().id());
            } catch (Operations.Refused late) {
                LOG.debug("{} has changed meanwhile: {}", follow.saved().id(), late.why());
            } catch (RuntimeException e) {
                logOnce(follow.saved().id(), e);
            }
        }
    }

    /** The same each second is said once. */
    private void logOnce(OperationId follow, RuntimeException e) {
        String why = String.valueOf(e.getMessage());
        if (!why.equals(troubles.put(follow, why))) {
            LOG.warn("Whether {} needs another drone is not known; it is looked again", follow, e);
        }
    }

    private void check(Snapshot<FollowState> follow) {
        FollowState state = follow.state();
        double left = state.isRelievable() ? secondsLeft(state) : Double.POSITIVE_INFINITY;
        if (left > EARLIEST_SECONDS) {
            return;
        }
        Optional<Principal> owner = owners.find(follow.saved().account());
        if (owner.isEmpty()) {
            // The follow itself ends for that.
            return;
        }
        Geodetic near = operations
                .newestReport(kind, follow.saved().id())
                .map(TargetReport::point)
                .orElse(state.order().near());
        Instant now = clock.instant().truncatedTo(ChronoUnit.MICROS);
        List<DroneState> candidates = candidates(owner.get(), state);
        PoolDroneSelector.Found found = drones.find(
                owner.get(), candidates, FollowService.task(near, state.order().place(), LEAST_MINUTES), now);
        if (found.chosen().isPresent()) {
            ChosenDrone chosen = found.chosen().get();
            if (left <= secondsNeeded(chosen, near, state)) {
                submit(follow, new FollowInput.SendRelief(now, chosen));
            }
        } else if (left <= TOLD_SECONDS && !state.reliefOrNone().aloneReported()) {
            submit(follow, new FollowInput.NoReliefAvailable(now, why(candidates, found)));
        }
    }

    private void submit(Snapshot<FollowState> follow, FollowInput what) {
        Snapshot<FollowState> unused = operations.request(kind, follow.saved().id(), what);
    }

    private static String why(List<DroneState> candidates, PoolDroneSelector.Found found) {
        return candidates.isEmpty() ? "No other drone of the warehouse is free." : found.why();
    }

    /** Until its drone has to fly home; 0 when it does already, and infinite when that is not known. */
    private double secondsLeft(FollowState state) {
        if (state.stage() == FollowStage.RETURNING) {
            return 0;
        }
        DroneState drone = cloud.drone(state.drone()).orElse(null);
        Battery battery = drone == null ? null : drone.battery();
        Position position = drone == null ? null : drone.position();
        Integer percent = battery == null ? null : battery.percent();
        Geodetic point = position == null ? null : position.point();
        return percent == null || point == null
                ? Double.POSITIVE_INFINITY
                : CopterEndurance.secondsLeft(
                        percent,
                        Geodesy.distanceMeters(point, state.order().chosen().home()));
    }

    /** The other one stands at its home, or not far from it. */
    private static double secondsNeeded(ChosenDrone chosen, Geodetic near, FollowState state) {
        double meters = Geodesy.distanceMeters(chosen.home(), near);
        return LONGER
                        * CopterEndurance.secondsToCome(
                                meters, state.order().place().heightMeters())
                + SPARE_SECONDS;
    }

    /** Nobody looks after it, nobody has it in hand, and it has not failed at this. */
    private List<DroneState> candidates(Principal owner, FollowState state) {
        Set<DroneId> waiting = warehouse.drones();
        return drones.commandable(owner).stream()
                .filter(drone -> waiting.contains(drone.id()) && drones.isFree(drone.id()))
                .filter(drone -> !drone.id().equals(state.drone())
                        && !state.reliefOrNone().failed().contains(drone.id())
                        && state.reliefOrNone().others().stream()
                                .noneMatch(other -> other.drone().equals(drone.id())))
                .toList();
    }

    @Override
    public void close() {
        thread.close();
    }
}
