package org.dronemap.core.drone;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** Wind that a vehicle estimated in flight: speed, the direction it comes from, and when. */
@Stored(names = "fromDegrees metersPerSecond heard")
public record Wind(double fromDegrees, double metersPerSecond, Instant receivedAt) {
    /** Farther away, and longer ago, it may well be another one. */
    private static final double NEAR_METERS = 10_000;

    private static final Duration LASTS = Duration.ofMinutes(20);

    /** The newest that anybody near that place felt; empty: nobody did lately. */
    public static Optional<Wind> near(Geodetic place, Collection<DroneState> drones, Instant now) {
        return drones.stream()
                .filter(drone -> !drone.replay() && isNear(place, drone))
                .flatMap(drone -> Stream.ofNullable(drone.payload().wind()))
                .filter(wind -> Duration.between(wind.receivedAt(), now).compareTo(LASTS) <= 0)
                .max(Comparator.comparing(Wind::receivedAt));
    }

    private static boolean isNear(Geodetic place, DroneState drone) {
        Geodetic point = drone.position() == null ? null : drone.position().point();
        return point != null && Geodesy.distanceMeters(place, point) <= NEAR_METERS;
    }
}
