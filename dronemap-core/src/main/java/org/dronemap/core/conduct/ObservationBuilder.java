package org.dronemap.core.conduct;

import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.operation.AirspaceSnapshot;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.separation.PossiblePlace;
import org.dronemap.core.separation.SeparationBoard;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.Zone;
import org.jspecify.annotations.Nullable;

/** Builds the observations of its drones that an operation decides on. Owned by the conductor's thread. */
final class ObservationBuilder {
    /** Zones that begin so soon are heeded already. */
    private static final Duration SOON = Duration.ofHours(1);

    private static final long KEPT_NANOS = 40_000_000L;

    private final CloudManager cloud;
    private final DroneGateway crew;
    private final OperationRights rights;
    private final SeparationBoard board;
    private final Clock clock;
    private final LinkLossTimer silence;
    private final StationaryTimer stillness;
    private final LongSupplier nanoTime;
    private List<DroneState> airborne = List.of();
    private long aloftNanos;

    ObservationBuilder(
            CloudManager cloud, DroneGateway crew, OperationRights rights, SeparationBoard board, Time time) {
        this.cloud = cloud;
        this.crew = crew;
        this.rights = rights;
        this.board = board;
        this.clock = time.clock();
        this.nanoTime = time::nanos;
        this.aloftNanos = nanoTime.getAsLong() - KEPT_NANOS;
        this.silence = new LinkLossTimer(nanoTime);
        this.stillness = new StationaryTimer(nanoTime);
    }

    /** In the order of their ids. */
    OperationObservation observe(SavedOperation of, OperationLeases reins, Set<DroneId> drones) {
        Map<DroneId, GiveWay> giveWays = board.giveWays();
        TreeMap<String, DroneState> states = new TreeMap<>();
        drones.forEach(id -> cloud.drone(id).ifPresent(state -> states.put(id.value(), state)));
        List<OperationObservation.ObservedDrone> seen = new ArrayList<>();
        for (DroneState state : states.values()) {
            seen.add(new OperationObservation.ObservedDrone(
                    state,
                    controlStatus(of, reins, state.id()),
                    silence.of(state),
                    stillness.of(state),
                    giveWay(giveWays.get(state.id()), state.id(), drones)));
        }
        return new OperationObservation(clock.instant(), seen);
    }

    /** Whoever reads what an operation saw may not know of drones that are none of its own. */
    private static @Nullable GiveWay giveWay(@Nullable GiveWay give, DroneId self, Set<DroneId> own) {
        return give == null || own.contains(give.to()) ? give : give.withoutNaming(self);
    }

    /** The same with what is around these drones. */
    OperationObservation withAirspace(SavedOperation of, OperationObservation scene, Set<DroneId> drones) {
        Map<DroneId, List<Zone>> zones = new HashMap<>();
        drones.forEach(id -> zones.put(
                id,
                cloud.zones().binding(of.owner(), id, scene.now(), scene.now().plus(SOON))));
        Map<DroneId, List<PossiblePlace>> silent = board.silent();
        List<DroneState> others = airborne().stream()
                .filter(drone -> !drones.contains(drone.id()) && !silent.containsKey(drone.id()))
                .toList();
        List<PossiblePlace> unheard = silent.entrySet().stream()
                .filter(entry -> !drones.contains(entry.getKey()))
                .flatMap(entry -> entry.getValue().stream())
                .toList();
        return new OperationObservation(
                scene.now(), scene.drones(), new AirspaceSnapshot(zones, others, unheard, crew.steeredDrones()));
    }

    /** Found once for all operations that look at about the same time. */
    private List<DroneState> airborne() {
        long now = nanoTime.getAsLong();
        if (now - aloftNanos >= KEPT_NANOS) {
            aloftNanos = now;
            airborne = cloud.drones().stream().filter(DroneState::airborne).toList();
        }
        return airborne;
    }

    private OperationObservation.ControlStatus controlStatus(SavedOperation of, OperationLeases reins, DroneId drone) {
        ControlState control = cloud.controls().control(drone);
        return new OperationObservation.ControlStatus(
                reins.whyNotHeld(drone),
                rights.whyNot(of, drone).orElse(null),
                control.isHeldBy(of.owner()),
                control.tenure() == null,
                cloud.gate().transfer(drone).orElse(null));
    }
}
