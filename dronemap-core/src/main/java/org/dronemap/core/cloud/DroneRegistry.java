package org.dronemap.core.cloud;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkState;
import org.jspecify.annotations.Nullable;

/** All drones, and which of them a new session is. Any thread. */
final class DroneRegistry {
    private final ConcurrentHashMap<DroneId, ManagedDrone> drones = new ConcurrentHashMap<>();

    void add(ManagedDrone drone) {
        drones.put(drone.id(), drone);
    }

    boolean remove(ManagedDrone drone) {
        return drones.remove(drone.id(), drone);
    }

    boolean contains(ManagedDrone drone) {
        return drones.get(drone.id()) == drone;
    }

    Optional<ManagedDrone> find(DroneId id) {
        return Optional.ofNullable(drones.get(id));
    }

    List<ManagedDrone> all() {
        return drones.values().stream()
                .sorted(Comparator.comparing(managed -> managed.id().value()))
                .toList();
    }

    /**
     * The drone that this evidence speaks for: the same hardware id (if its old session is silent), else the same
     * IP:port:sysid with no contradiction in the hardware ids.
     */
    Optional<ManagedDrone> recognise(DroneKey key, Identification identification) {
        String uid = identification.hardwareUid();
        Optional<ManagedDrone> sameKey = physical()
                .filter(managed -> managed.drone().state().link().key().equals(key))
                .filter(managed -> compatible(uid, uidOf(managed)))
                .findFirst();
        if (uid == null || sameKey.isPresent()) {
            return sameKey;
        }
        return physical()
                .filter(managed -> Objects.equals(uid, uidOf(managed)))
                .filter(managed -> managed.drone().state().link().state() != LinkState.LIVE)
                .findFirst();
    }

    /** A live drone that claims the same hardware id: one of the two is not what it says. */
    Optional<DroneState> liveTwin(DroneId self, Identification identification) {
        String uid = identification.hardwareUid();
        return physical()
                .map(managed -> managed.drone().state())
                .filter(state -> uid != null && !state.id().equals(self))
                .filter(state -> Objects.equals(uid, state.identification().hardwareUid()))
                .filter(state -> state.link().state() == LinkState.LIVE)
                .findFirst();
    }

    private Stream<ManagedDrone> physical() {
        return drones.values().stream()
                .filter(managed -> !managed.drone().state().replay());
    }

    private static @Nullable String uidOf(ManagedDrone managed) {
        return managed.drone().state().identification().hardwareUid();
    }

    private static boolean compatible(@Nullable String one, @Nullable String other) {
        return one == null || other == null || one.equals(other);
    }
}
