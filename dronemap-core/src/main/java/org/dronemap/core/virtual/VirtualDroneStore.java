package org.dronemap.core.virtual;

import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.DroneId;

/** Stores virtual drones with their runs, and the warehouse of drones that may serve them; writes are durable. */
public interface VirtualDroneStore {
    /** All of them, the oldest first. */
    List<VirtualDrone> virtualDrones();

    /**
     * Inserts or replaces.
     *
     * @throws RuntimeException when another one is bound to the same drone, and then nothing is written
     */
    void save(VirtualDrone drone);

    /** True when there was one. */
    boolean delete(VirtualDroneId id);

    /** Drones that may serve virtual ones. */
    Set<DroneId> warehouse();

    /** The drone must be known. Once more is as good as once. */
    void addToWarehouse(DroneId drone);

    /** True when it was there. */
    boolean removeFromWarehouse(DroneId drone);
}
