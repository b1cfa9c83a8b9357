package org.dronemap.core.separation;

import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodesy;
import org.jspecify.annotations.Nullable;

/**
 * Extra height between two drones whose heights do not count from one ground. Each vehicle measures from where it was
 * armed; how high that lies it has from satellites, up to {@value #BIAS_METERS} m wrong. Two that stand near each other
 * and say that they stand equally high are level; of all others nobody knows.
 */
public final class VerticalMargin {
    private static final double BIAS_METERS = 5;
    private static final double NEAR_METERS = 500;
    private static final double LEVEL_METERS = 1.5;

    private VerticalMargin() {}

    /** In metres. */
    static double between(TrackedDrone one, TrackedDrone other) {
        return between(one.state().home(), other.state().home());
    }

    /** The same by their homes; null: not known. */
    public static double between(@Nullable Home one, @Nullable Home other) {
        return areLevel(one, other) ? 0 : 2 * BIAS_METERS;
    }

    private static boolean areLevel(@Nullable Home one, @Nullable Home other) {
        return one != null
                && other != null
                && Math.abs(one.altitudeAmslMeters() - other.altitudeAmslMeters()) <= LEVEL_METERS
                && Geodesy.distanceMeters(one.point(), other.point()) <= NEAR_METERS;
    }
}
