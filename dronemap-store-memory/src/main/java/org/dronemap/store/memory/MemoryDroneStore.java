package org.dronemap.store.memory;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;

/**
 * Keeps drones, and the mission last known to be on each, in memory, for tests. Thread-safe: every method holds the
 * object's lock.
 */
public final class MemoryDroneStore implements DroneStore {
    private final Map<DroneId, DroneRecord> drones = new HashMap<>();
    private final Map<DroneId, KnownMission> missions = new HashMap<>();

    @Override
    public synchronized List<DroneRecord> drones() {
        return drones.values().stream()
                .sorted(Comparator.comparing(drone -> drone.id().value()))
                .toList();
    }

    @Override
    public synchronized void save(DroneRecord drone) {
        DroneRecord kept = new DroneRecord(
                drone.id(),
                drone.name(),
                drone.key(),
                drone.transport(),
                drone.identification(),
                drone.standing(),
                StoredInstant.of(drone.lastHeard()),
                drone.groundAmslMeters());
        drones.put(kept.id(), kept);
    }

    @Override
    public synchronized void delete(DroneId id) {
        drones.remove(id);
        missions.remove(id);
    }

    @Override
    public synchronized Optional<KnownMission> knownMission(DroneId id) {
        return Optional.ofNullable(missions.get(id));
    }

    @Override
    public synchronized void saveKnownMission(DroneId id, KnownMission mission) {
        if (!drones.containsKey(id)) {
            throw new StoreException("There is no drone " + id + " to keep a mission of.");
        }
        missions.put(id, mission);
    }
}
