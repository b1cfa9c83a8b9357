package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A rally point that a vehicle may return to instead of home, with its height and what that is measured from.
 *
 * @param given null: above home, as earlier versions wrote down
 */
@Stored(names = "point altitudeMeters reference", later = "reference")
public record RallyPoint(
        Geodetic point, double altitudeMeters, @Nullable HeightReference given) {
    /** Above home. */
    public RallyPoint(Geodetic point, double altitudeMeters) {
        this(point, altitudeMeters, null);
    }

    public RallyPoint {
        if (!(Math.abs(altitudeMeters) <= Altitude.HIGHEST_PLANNED_METERS)) {
            throw new IllegalArgumentException("a rally point is at -10000 to 10000 m: " + altitudeMeters);
        }
        if (given == HeightReference.HOME) {
            given = null;
        }
    }

    public HeightReference reference() {
        return given == null ? HeightReference.HOME : given;
    }
}
