package org.dronemap.core.history;

import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Totals of a flight: distance, heights, speed and battery; each null while unknown.
 *
 * @param distanceMeters along the ground
 * @param highestMeters above home
 * @param fastest over ground, m/s
 * @param farthestMeters from where it was armed
 * @param batteryFirst percent when it was armed
 * @param batteryLast percent when last heard of
 * @param takeOff where it was armed
 * @param last where it was last heard of
 */
public record FlightStatistics(
        double distanceMeters,
        @Nullable Double highestMeters,
        @Nullable Double fastest,
        @Nullable Double farthestMeters,
        @Nullable Integer batteryFirst,
        @Nullable Integer batteryLast,
        @Nullable Geodetic takeOff,
        @Nullable Geodetic last) {
    public static final FlightStatistics NONE = new FlightStatistics(0, null, null, null, null, null, null, null);

    /** In percent of a full charge; null when it is not known. */
    public @Nullable Integer batteryUsed() {
        return batteryFirst == null || batteryLast == null ? null : (Integer) Math.max(0, batteryFirst - batteryLast);
    }

    FlightStatistics with(TelemetryPoint point) {
        Geodetic place = point.position() == null ? null : point.position().point();
        Double height = TelemetryField.ALTITUDE_ABOVE_HOME.of(point);
        Double speed = TelemetryField.GROUND_SPEED.of(point);
        Integer battery = point.battery() == null ? null : point.battery().percent();
        Geodetic home = takeOff == null ? place : takeOff;
        return new FlightStatistics(
                distanceMeters,
                most(highestMeters, height),
                most(fastest, speed),
                place == null || home == null
                        ? farthestMeters
                        : most(farthestMeters, Geodesy.distanceMeters(home, place)),
                batteryFirst == null ? battery : batteryFirst,
                battery == null ? batteryLast : battery,
                home,
                place == null ? last : place);
    }

    FlightStatistics andFlown(double meters) {
        return new FlightStatistics(
                distanceMeters + meters,
                highestMeters,
                fastest,
                farthestMeters,
                batteryFirst,
                batteryLast,
                takeOff,
                last);
    }

    private static @Nullable Double most(@Nullable Double one, @Nullable Double other) {
        if (one == null || other == null) {
            return one == null ? other : one;
        }
        return Math.max(one, other);
    }
}
