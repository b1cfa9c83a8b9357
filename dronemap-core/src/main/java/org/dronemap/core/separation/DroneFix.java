package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/**
 * A drone's reported position with its velocity in m/s, estimated from this position and the one before.
 *
 * @param at when it was there
 */
public record DroneFix(Instant at, Geodetic point, double altitudeAmslMeters, double eastward, double northward) {
    private static final double LEAST_SECONDS = 0.05;
    private static final double LONGEST_SECONDS = 2;
    private static final double NANOS = 1e9;

    /** Where it is later; how it moves follows from that. */
    public DroneFix moved(Instant later, Geodetic to, double amslMeters) {
        double seconds = Duration.between(at, later).toNanos() / NANOS;
        if (seconds < LEAST_SECONDS) {
            return new DroneFix(later, to, amslMeters, eastward, northward);
        }
        if (seconds > LONGEST_SECONDS) {
            return new DroneFix(later, to, amslMeters, 0, 0);
        }
        PlanePoint way = LocalPlane.offset(point, to);
        return new DroneFix(later, to, amslMeters, way.eastMeters() / seconds, way.northMeters() / seconds);
    }
}
