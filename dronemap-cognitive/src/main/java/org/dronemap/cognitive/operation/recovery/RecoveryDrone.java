package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;

/**
 * One flying drone that a recovery is planned for.
 *
 * @param place where it stands
 * @param heightMeters above its home
 * @param highestMeters above its home: the most that zones and the order let it fly home at
 */
public record RecoveryDrone(
        DroneId drone, String name, Geodetic place, double heightMeters, Home home, double highestMeters) {
    /** So near its home it comes straight down. */
    private static final double OVER_HOME_METERS = 3;

    double amslMeters() {
        return home.altitudeAmslMeters() + heightMeters;
    }

    boolean isOverHome() {
        return Geodesy.distanceMeters(place, home.point()) < OVER_HOME_METERS;
    }

    /** It stands above its home already, as high as it flies home. */
    boolean isStraightDown(double layerMeters) {
        return isOverHome() && Math.abs(layerMeters - heightMeters) < 0.5;
    }
}
