package org.dronemap.core.drone;

import java.util.List;

/**
 * Stores the owners' parameter values that the cloud has overridden; every write returns only after it is durable. What
 * is kept outlives the drone.
 */
public interface ParameterOverrideStore {
    /** In the order of the drones' ids. */
    List<ParameterOverrides> all();

    /** Inserts or replaces what is kept of that drone. */
    void save(ParameterOverrides values);

    void delete(DroneId drone);
}
