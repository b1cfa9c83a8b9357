package org.dronemap.ws.drone;

import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Caches the name of the nearest place of each drone, and looks it up again when the drone has moved far enough. Any
 * thread.
 */
public final class DronePlaceNames implements CloudListener {
    private static final double FAR_ENOUGH_METERS = 200;

    private final Function<Geodetic, @Nullable String> lookup;
    private final ConcurrentHashMap<DroneId, Named> known = new ConcurrentHashMap<>();

    private record Named(Geodetic point, @Nullable String place) {}

    public DronePlaceNames(Function<Geodetic, @Nullable String> lookup) {
        this.lookup = lookup;
    }

    @Nullable
    String place(DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        if (point == null) {
            return null;
        }
        Named before = known.get(drone.id());
        if (before != null && Geodesy.distanceMeters(before.point(), point) <= FAR_ENOUGH_METERS) {
            return before.place();
        }
        Named now = new Named(point, lookup.apply(point));
        known.put(drone.id(), now);
        return now.place();
    }

    @Override
    public void droneRemoved(DroneId id) {
        known.remove(id);
    }
}
