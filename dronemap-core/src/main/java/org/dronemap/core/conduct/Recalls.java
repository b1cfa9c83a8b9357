package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.virtual.VirtualDrone;

/**
 * Calls drones home that fell silent while they served, once they are heard again: others may fly their waypoints by now.
 * Owned by the conductor's thread.
 */
final class Recalls {
    private final CloudManager cloud;
    private final VirtualBook book;
    private final WayHome wayHome;

    Recalls(CloudManager cloud, VirtualBook book, WayHome wayHome) {
        this.cloud = cloud;
        this.book = book;
        this.wayHome = wayHome;
    }

    void goOn(VirtualDrone drone) {
        for (DroneId id : drone.recalled()) {
            Optional<DroneState> state = cloud.drone(id);
            if (state.isEmpty() || wayHome.isSeenTo(VirtualHolder.of(drone), state.get())) {
                book.find(drone.id()).ifPresent(now -> book.put(now.home(id)));
            }
        }
    }
}
