package org.dronemap.cognitive.problem;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.stored.Stored;

/** A point of a planning problem or plan: WGS-84, metres above mean sea level. */
@Stored(names = "point altitudeAmslMeters")
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
