package org.dronemap.core.lease;

import java.util.List;
import org.dronemap.core.drone.DroneId;

/** Keeps who has control, and which epochs were ever handed out; every write returns only after it is durable. */
public interface LeaseStore {
    List<SavedLease> leases();

    /** Inserts or replaces. */
    void save(SavedLease lease);

    void delete(DroneId drone);

    /** Sets so many epochs aside that were never set aside before, each above all earlier ones; returns the last. */
    long reserve(int count);
}
