package org.dronemap.core.separation;

import java.time.Instant;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Estimates the velocities of a following drone and of drones near it from their successive reported positions. Owned
 * by the conductor's thread.
 */
public final class VelocityEstimates {
    private static final double FAR_METERS = 300;

    private final Map<DroneId, DroneFix> known = new HashMap<>();

    /** Null: where it is, is not known. */
    public @Nullable DroneFix of(DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        Double amsl = position == null ? null : position.altitudeAmslMeters();
        if (point == null || amsl == null) {
            return null;
        }
        DroneFix before = known.get(drone.id());
        Instant at = drone.lastUpdate();
        if (before == null) {
            before = new DroneFix(at, point, amsl, 0, 0);
        } else if (!before.point().equals(point) || before.altitudeAmslMeters() != amsl) {
            before = before.moved(at, point, amsl);
        }
        known.put(drone.id(), before);
        return before;
    }

    /** As its positions show it; standing where nothing is known of it. */
    public GroundVelocity velocity(DroneId drone) {
        DroneFix fix = known.get(drone);
        return fix == null ? GroundVelocity.NONE : new GroundVelocity(fix.eastward(), fix.northward());
    }

    public void retainOnly(Set<DroneId> drones) {
        known.keySet().retainAll(drones);
    }

    /** Those that are near this one; the others are forgotten. */
    public Map<DroneId, DroneFix> of(List<DroneState> others, DroneState drone) {
        Position position = drone.position();
        Geodetic here = position == null ? null : position.point();
        Map<DroneId, DroneFix> near = new LinkedHashMap<>();
        for (DroneState other : others) {
            Position there = other.position();
            Geodetic point = there == null ? null : there.point();
            boolean isNear = here != null && point != null && Geodesy.distanceMeters(here, point) < FAR_METERS;
            DroneFix one = isNear ? of(other) : null;
            if (one != null) {
                near.put(other.id(), one);
            }
        }
        known.keySet().removeIf(id -> !near.containsKey(id) && !id.equals(drone.id()));
        return near;
    }
}
