package org.dronemap.cognitive.operation.dispatch;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/**
 * The order of a dispatch: the place where a drone is wanted.
 *
 * @param heightMeters above the home of the drone that comes
 */
@Stored(names = "place heightMeters")
public record DispatchOrder(Geodetic place, double heightMeters) {
    public static final double LOWEST_METERS = 5;

    public static final double HIGHEST_METERS = 120;
}
