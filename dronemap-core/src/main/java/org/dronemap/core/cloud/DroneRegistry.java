package org.dronemap.core.cloud;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.jspecify.annotations.Nullable;

/** In-memory registry of all drones, found by id or by hardware id. Any thread. */
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

    /** The drone that speaks, or last spoke, from this address, unless its hardware id contradicts. */
    Optional<ManagedDrone> at(DroneKey key, @Nullable String uid) {
        return physical()
                .filter(managed -> managed.speaksFrom(key))
                .filter(managed -> compatible(uid, uidOf(managed)))
                .findFirst();
    }

    /** The drones that said this hardware id, where it counts for anything. */
    List<ManagedDrone> ofHardware(@Nullable String uid) {
        return physical()
                .filter(managed -> uid != null && uid.equals(uidOf(managed)))
                .filter(managed -> !managed.drone().state().standing().distinct())
                .toList();
    }

    /** Whom a vehicle says that it is, true or not. */
    Optional<ManagedDrone> claimedBy(DroneKey key, @Nullable String uid) {
        List<ManagedDrone> sameHardware = ofHardware(uid);
        return sameHardware.size() == 1 ? Optional.of(sameHardware.get(0)) : at(key, uid);
    }

    /** The drone that came with this key before, or that the key was made for: it is named after it. */
    Optional<ManagedDrone> ofLinkIdentity(String identity) {
        return physical().filter(managed -> managed.hasLinkIdentity(identity)).findFirst();
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
