package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/**
 * The place that a vehicle's own fence sends it to after a breach. ArduPilot keeps no height of it and shows 0 m above
 * sea level.
 */
@Stored(names = "point altitudeMeters reference")
public record FenceReturnPoint(Geodetic point, double altitudeMeters, HeightReference reference) {
    public FenceReturnPoint {
        if (!(Math.abs(altitudeMeters) <= Altitude.HIGHEST_PLANNED_METERS)) {
            throw new IllegalArgumentException(
                    "the return point of a fence is at -10000 to 10000 m: " + altitudeMeters);
        }
    }

    /** Without a height. */
    public static FenceReturnPoint of(Geodetic point) {
        return new FenceReturnPoint(point, 0, HeightReference.AMSL);
    }

    public boolean hasHeight() {
        return altitudeMeters != 0 || reference != HeightReference.AMSL;
    }
}
