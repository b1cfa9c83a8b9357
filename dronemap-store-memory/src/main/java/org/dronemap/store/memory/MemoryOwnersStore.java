package org.dronemap.store.memory;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.OwnersStore;
import org.dronemap.core.drone.OwnersValues;
import org.dronemap.store.StoredInstant;

/**
 * Parameter values of owners, kept while the cloud overrides them, in memory. Thread-safe: every method holds the
 * object's lock.
 */
public final class MemoryOwnersStore implements OwnersStore {
    private final SortedMap<String, OwnersValues> kept = new TreeMap<>();

    @Override
    public synchronized List<OwnersValues> all() {
        return List.copyOf(kept.values());
    }

    @Override
    public synchronized void save(OwnersValues values) {
        kept.put(
                values.drone().value(),
                new OwnersValues(
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
