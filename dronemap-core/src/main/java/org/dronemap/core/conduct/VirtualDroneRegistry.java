package org.dronemap.core.conduct;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.core.virtual.VirtualRun;

/**
 * In-memory registry of all virtual drones and of the drones that may serve them; stores each change first. Read by any
 * thread, written by one.
 */
final class VirtualDroneRegistry {
    private static final Comparator<VirtualDrone> OLDEST_FIRST = Comparator.comparing(VirtualDrone::createdAt)
            .thenComparing(drone -> drone.id().value());

    private final VirtualDroneStore store;
    private final ConcurrentHashMap<VirtualDroneId, VirtualDrone> drones = new ConcurrentHashMap<>();
    private final Set<DroneId> warehouse = ConcurrentHashMap.newKeySet();
    private final CopyOnWriteArrayList<VirtualDroneListener> listeners = new CopyOnWriteArrayList<>();

    VirtualDroneRegistry(VirtualDroneStore store) {
        this.store = store;
        store.virtualDrones().forEach(drone -> drones.put(drone.id(), drone));
        warehouse.addAll(store.warehouse());
    }

    void addListener(VirtualDroneListener listener) {
        listeners.add(listener);
    }

    List<VirtualDrone> all() {
        return drones.values().stream().sorted(OLDEST_FIRST).toList();
    }

    Optional<VirtualDrone> find(VirtualDroneId id) {
        return Optional.ofNullable(drones.get(id));
    }

    /** Who asked first comes first. */
    List<VirtualDrone> waiting() {
        return drones.values().stream()
                .filter(VirtualDrone::isWaiting)
                .sorted(Comparator.comparingLong(VirtualDroneRegistry::ticket))
                .toList();
    }

    long nextTicket() {
        return 1
                + drones.values().stream()
                        .mapToLong(VirtualDroneRegistry::ticket)
                        .max()
                        .orElse(0);
    }

    private static long ticket(VirtualDrone drone) {
        return drone.runs().stream().mapToLong(VirtualRun::ticket).findFirst().orElse(0);
    }

    void put(VirtualDrone drone) {
        if (drone.equals(drones.get(drone.id()))) {
            return;
        }
        store.save(drone);
        drones.put(drone.id(), drone);
        listeners.forEach(listener -> listener.changed(drone));
    }

    void remove(VirtualDrone drone) {
        store.delete(drone.id());
        drones.remove(drone.id());
        listeners.forEach(listener -> listener.removed(drone));
    }

    Set<DroneId> warehouse() {
        return Set.copyOf(warehouse);
    }

    void addToWarehouse(DroneId drone) {
        store.addToWarehouse(drone);
        warehouse.add(drone);
    }

    void removeFromWarehouse(DroneId drone) {
        store.removeFromWarehouse(drone);
        warehouse.remove(drone);
    }

    /** It is gone from the store with its drone. */
    void forget(DroneId drone) {
        warehouse.remove(drone);
    }
}
