package org.dronemap.core.conduct;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Measures for how long drones have stayed at one place, for operations and virtual drones. Owned by the conductor's
 * thread.
 */
final class StationaryTimer {
    /** Less than this is the receiver's own wandering. */
    private static final double MOVED_METERS = 1.5;

    private final LongSupplier nanoTime;
    private final Map<DroneId, Fix> fixes = new HashMap<>();

    private record Fix(Geodetic point, double height, long nanos) {}

    StationaryTimer(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Nothing while it is not known where it is. */
    Duration of(DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        boolean heard = drone.link().state() == LinkState.LIVE && Boolean.TRUE.equals(drone.armed());
        if (position == null || point == null || !heard) {
            fixes.remove(drone.id());
            return Duration.ZERO;
        }
        double height = height(position.altitudeAboveHomeMeters());
        Fix last = fixes.get(drone.id());
        long now = nanoTime.getAsLong();
        if (last == null
                || Geodesy.distanceMeters(last.point(), point) > MOVED_METERS
                || Math.abs(last.height() - height) > MOVED_METERS) {
            last = new Fix(point, height, now);
            fixes.put(drone.id(), last);
        }
        return Duration.ofNanos(now - last.nanos());
    }

    private static double height(@Nullable Double aboveHome) {
        return aboveHome == null ? 0 : aboveHome;
    }
}
