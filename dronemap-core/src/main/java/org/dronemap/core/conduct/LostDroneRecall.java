package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.virtual.VirtualDrone;

/**
 * Sends drones home that lost contact while serving a virtual drone, once they are heard again. Owned by the
 * conductor's thread.
 */
final class LostDroneRecall {
    private final CloudManager cloud;
    private final VirtualDroneRegistry book;
    private final ReturnCommander wayHome;

    LostDroneRecall(CloudManager cloud, VirtualDroneRegistry book, ReturnCommander wayHome) {
        this.cloud = cloud;
        this.book = book;
        this.wayHome = wayHome;
    }

    void recall(VirtualDrone drone) {
        for (DroneId id : drone.recalled()) {
            Optional<DroneState> state = cloud.drone(id);
            if (state.isEmpty() || wayHome.commandReturn(VirtualLeaseHolders.of(drone), state.get())) {
                book.find(drone.id()).ifPresent(now -> book.put(now.home(id)));
            }
        }
    }
}
