package org.dronemap.core.conduct;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.FlightPace;
import org.dronemap.core.separation.GroundVelocity;
import org.jspecify.annotations.Nullable;

/**
 * Follows how drones move over the ground by the positions that they report, and how fast they were seen on missions.
 * One thread.
 */
final class GroundVelocityTracker {
    private static final double SHORTEST_SECONDS = 0.4;
    private static final double LONGEST_SECONDS = 3;
    private static final double MILLIS = 1_000;

    private final Map<DroneId, Movement> known = new HashMap<>();

    private record Movement(Instant at, Geodetic point, GroundVelocity velocity, double fastest) {}

    /** What it is by now, with what was seen of it before. */
    void observe(DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        if (point == null) {
            return;
        }
        Movement before = known.get(drone.id());
        known.put(drone.id(), before == null ? begun(drone, point) : moved(before, drone, point));
    }

    private static Movement begun(DroneState drone, Geodetic point) {
        return new Movement(drone.lastUpdate(), point, GroundVelocity.NONE, 0);
    }

    private static Movement moved(Movement before, DroneState drone, Geodetic point) {
        double seconds = Duration.between(before.at(), drone.lastUpdate()).toMillis() / MILLIS;
        if (seconds < SHORTEST_SECONDS) {
            return before;
        }
        if (seconds > LONGEST_SECONDS) {
            return new Movement(drone.lastUpdate(), point, GroundVelocity.NONE, before.fastest());
        }
        PlanePoint way = LocalPlane.offset(before.point(), point);
        GroundVelocity velocity = new GroundVelocity(way.eastMeters() / seconds, way.northMeters() / seconds);
        boolean flies = drone.capabilities()
                .steering(drone.mode())
                .filter(by -> by == Steering.MISSION)
                .isPresent();
        double fastest = flies ? Math.max(before.fastest(), velocity.speed()) : before.fastest();
        return new Movement(drone.lastUpdate(), point, velocity, fastest);
    }

    GroundVelocity velocity(DroneId drone) {
        Movement movement = known.get(drone);
        return movement == null ? GroundVelocity.NONE : movement.velocity();
    }

    FlightPace pace(DroneState drone) {
        @Nullable Movement movement = known.get(drone.id());
        FlightPace usual = FlightPace.of(drone.identification().kind());
        return movement == null ? usual : usual.atLeast(movement.fastest());
    }

    void retainOnly(Set<DroneId> drones) {
        known.keySet().retainAll(drones);
    }
}
