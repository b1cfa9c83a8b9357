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
import org.dronemap.core.zone.Zone;

/** Builds the observations of its drones that an operation decides on. Owned by the conductor's thread. */
final class ObservationBuilder {
    /** Zones that begin so soon are heeded already. */
    private static final Duration SOON = Duration.ofHours(1);

    private static final long KEPT_NANOS = 40_000_000L;

    private final CloudManager cloud;
    private final DroneGateway crew;
    private final OperationRights rights;
    private final Clock clock;
    private final LinkLossTimer silence;
    private final StationaryTimer stillness;
    private final LongSupplier nanoTime;
    private List<DroneState> airborne = List.of();
    private long aloftNanos;

    ObservationBuilder(
            CloudManager cloud, DroneGateway crew, OperationRights rights, Clock clock, LongSupplier nanoTime) {
        this.cloud = cloud;
        this.crew = crew;
        this.rights = rights;
        this.clock = clock;
        this.nanoTime = nanoTime;
        this.aloftNanos = nanoTime.getAsLong() - KEPT_NANOS;
        this.silence = new LinkLossTimer(nanoTime);
        this.stillness = new StationaryTimer(nanoTime);
    }

    /** In the order of their ids. */
    OperationObservation observe(SavedOperation of, OperationLeases reins, Set<DroneId> drones) {
        TreeMap<String, DroneState> states = new TreeMap<>();
        drones.forEach(id -> cloud.drone(id).ifPresent(state -> states.put(id.value(), state)));
        List<OperationObservation.ObservedDrone> seen = new ArrayList<>();
        for (DroneState state : states.values()) {
            seen.add(new OperationObservation.ObservedDrone(
                    state, controlStatus(of, reins, state.id()), silence.of(state), stillness.of(state)));
        }
        return new OperationObservation(clock.instant(), seen);
    }

    /** The same with what is around these drones. */
    OperationObservation withAirspace(SavedOperation of, OperationObservation scene, Set<DroneId> drones) {
        Map<DroneId, List<Zone>> zones = new HashMap<>();
        drones.forEach(id -> zones.put(
                id,
                cloud.zones().binding(of.owner(), id, scene.now(), scene.now().plus(SOON))));
        List<DroneState> others = airborne().stream()
                .filter(drone -> !drones.contains(drone.id()))
                .toList();
        return new OperationObservation(
                scene.now(), scene.drones(), new AirspaceSnapshot(zones, others, crew.steeredDrones()));
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
