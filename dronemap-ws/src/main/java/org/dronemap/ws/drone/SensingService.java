package org.dronemap.ws.drone;

import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.drone.SensorSnapshot;

/** Returns the latest laser scan, camera picture and map of a drone to users who may see it. Any thread. */
final class SensingService {
    private final CloudManager cloud;
    private final DroneService drones;

    SensingService(CloudManager cloud, DroneService drones) {
        this.cloud = cloud;
        this.drones = drones;
    }

    SensingView sensed(Principal principal, String droneId) {
        return SensingView.of(of(principal, droneId));
    }

    /** Empty when none came yet. */
    Optional<Picture> picture(Principal principal, String droneId) {
        return Optional.ofNullable(of(principal, droneId).picture()).map(SensorSnapshot.Sample::value);
    }

    /** Empty when none came yet. */
    Optional<Picture> map(Principal principal, String droneId) {
        return Optional.ofNullable(of(principal, droneId).map())
                .map(kept -> kept.value().picture());
    }

    private SensorSnapshot of(Principal principal, String droneId) {
        return cloud.sensed(drones.state(principal, droneId).id());
    }
}
