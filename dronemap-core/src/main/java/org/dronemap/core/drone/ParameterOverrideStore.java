package org.dronemap.core.drone;

import java.util.List;

/**
 * Keeps what owners had set on their drones until it is put back; every write returns only after it is durable. What is kept
 * outlives the drone.
 */
public interface ParameterOverrideStore {
    /** In the order of the drones' ids. */
    List<ParameterOverrides> all();

    /** Inserts or replaces what is kept of that drone. */
    void save(ParameterOverrides values);

    void delete(DroneId drone);
}
