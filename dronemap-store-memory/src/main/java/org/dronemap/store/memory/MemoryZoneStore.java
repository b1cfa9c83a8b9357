package org.dronemap.store.memory;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.ZoneOrdering;

/** Keeps the zones in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryZoneStore implements ZoneStore {
    private final Map<String, Zone> zones = new HashMap<>();

    @Override
    public synchronized List<Zone> zones() {
        return zones.values().stream().sorted(ZoneOrdering.BY_NAME).toList();
    }

    @Override
    public synchronized void save(List<Zone> saved) {
        saved.forEach(zone -> zones.put(zone.id(), zone));
    }

    @Override
    public synchronized boolean delete(String id) {
        return zones.remove(id) != null;
    }
}
