package org.dronemap.store.memory;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.store.StoredInstant;

/**
 * Keeps in memory, for tests, the owners' parameter values that the cloud overrides on their drones. Thread-safe: every
 * method holds the object's lock.
 */
public final class MemoryParameterOverrideStore implements ParameterOverrideStore {
    private final SortedMap<String, ParameterOverrides> kept = new TreeMap<>();

    @Override
    public synchronized List<ParameterOverrides> all() {
        return List.copyOf(kept.values());
    }

    @Override
    public synchronized void save(ParameterOverrides values) {
        kept.put(
                values.drone().value(),
                new ParameterOverrides(
                        values.drone(),
                        values.droneName(),
                        StoredInstant.of(values.since()),
                        values.returnMeters(),
                        values.written(),
                        values.values()));
    }

    @Override
    public synchronized void delete(DroneId drone) {
        kept.remove(drone.value());
    }
}
