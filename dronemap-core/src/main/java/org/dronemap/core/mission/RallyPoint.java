package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** A rally point that a vehicle may return to instead of home; its height is above home. */
@Stored(names = "point altitudeMeters")
public record RallyPoint(Geodetic point, double altitudeMeters) {
    public RallyPoint {
        if (!(Math.abs(altitudeMeters) <= Altitude.HIGHEST_PLANNED_METERS)) {
            throw new IllegalArgumentException("a rally point is at most 10000 m above home: " + altitudeMeters);
        }
    }
}
