package org.dronemap.cognitive.problem;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;

/** A point in space: WGS-84, metres above mean sea level. */
public record Place(Geodetic point, double altitudeAmslMeters) {
    public Place {
        Require.within(
                "altitudeAmslMeters",
                altitudeAmslMeters,
                Altitude.LOWEST_PLANNED_METERS,
                Altitude.HIGHEST_PLANNED_METERS);
    }

    public Place at(double meters) {
        return new Place(point, meters);
    }
}
