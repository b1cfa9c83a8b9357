package org.dronemap.core.lease;

import java.util.List;
import org.dronemap.core.drone.DroneId;

/** Stores who controls each drone and which control epochs were handed out; writes return only once durable. */
public interface LeaseStore {
    List<SavedLease> leases();

    /** Inserts or replaces. */
    void save(SavedLease lease);

    void delete(DroneId drone);

    /** Sets so many epochs aside that were never set aside before, each above all earlier ones; returns the last. */
    long reserve(int count);
}
