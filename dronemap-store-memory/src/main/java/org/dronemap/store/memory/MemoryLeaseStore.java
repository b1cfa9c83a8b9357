package org.dronemap.store.memory;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.store.StoredInstant;

/** Keeps the leases of control over drones in memory, for tests. Thread-safe: every method holds the object's lock. */
public final class MemoryLeaseStore implements LeaseStore {
    private final SortedMap<String, SavedLease> leases = new TreeMap<>();
    private long reserved;

    @Override
    public synchronized List<SavedLease> leases() {
        return List.copyOf(leases.values());
    }

    @Override
    public synchronized void save(SavedLease lease) {
        leases.put(
                lease.drone().value(),
                new SavedLease(
                        lease.drone(),
                        lease.user(),
                        StoredInstant.of(lease.since()),
                        lease.epoch(),
                        lease.lapsed(),
                        lease.mode()));
    }

    @Override
    public synchronized void delete(DroneId drone) {
        leases.remove(drone.value());
    }

    @Override
    public synchronized long reserve(int count) {
        reserved += count;
        return reserved;
    }
}
