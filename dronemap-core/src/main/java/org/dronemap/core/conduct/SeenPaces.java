package org.dronemap.core.conduct;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.FlightPace;
import org.jspecify.annotations.Nullable;

/** Remembers how fast drones were seen on missions, since vehicles do not say how fast they fly them. One thread. */
final class SeenPaces {
    private final Map<DroneId, Double> fastest = new HashMap<>();

    void observe(DroneState drone, @Nullable DroneFix fix) {
        boolean flies = drone.capabilities()
                .steering(drone.mode())
                .filter(by -> by == Steering.MISSION)
                .isPresent();
        if (fix != null && flies) {
            fastest.merge(drone.id(), Math.hypot(fix.eastward(), fix.northward()), Math::max);
        }
    }

    FlightPace of(DroneState drone) {
        return FlightPace.of(drone.identification().kind()).atLeast(fastest.getOrDefault(drone.id(), 0.0));
    }

    void retainOnly(Set<DroneId> drones) {
        fastest.keySet().retainAll(drones);
    }
}
