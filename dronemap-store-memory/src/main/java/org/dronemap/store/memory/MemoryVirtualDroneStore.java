package org.dronemap.store.memory;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.store.StoreException;

/**
 * Keeps virtual drones (a user owns one, a real drone flies for it), and which real drones are in the warehouse to
 * serve them, in memory, for tests. Thread-safe: every method holds the object's lock.
 */
public final class MemoryVirtualDroneStore implements VirtualDroneStore {
    private final Map<VirtualDroneId, VirtualDrone> drones = new HashMap<>();
    private final Set<DroneId> warehouse = new HashSet<>();

    @Override
    public synchronized List<VirtualDrone> virtualDrones() {
        return drones.values().stream()
                .sorted(Comparator.comparing(VirtualDrone::createdAt)
                        .thenComparing(drone -> drone.id().value()))
                .toList();
    }

    @Override
    public synchronized void save(VirtualDrone drone) {
        Set<DroneId> others = drones.values().stream()
                .filter(other -> !other.id().equals(drone.id()))
                .flatMap(other -> other.bound().stream())
                .collect(Collectors.toSet());
        drone.bound().stream().filter(others::contains).findFirst().ifPresent(taken -> {
            throw new StoreException("The drone " + taken + " serves another virtual drone.");
        });
        drones.put(drone.id(), drone);
    }

    @Override
    public synchronized boolean delete(VirtualDroneId id) {
        return drones.remove(id) != null;
    }

    @Override
    public synchronized Set<DroneId> warehouse() {
        return Set.copyOf(warehouse);
    }

    @Override
    public synchronized void addToWarehouse(DroneId drone) {
        warehouse.add(drone);
    }

    @Override
    public synchronized boolean removeFromWarehouse(DroneId drone) {
        return warehouse.remove(drone);
    }
}
