package org.dronemap.core.zone;

import java.util.List;
import org.dronemap.core.mission.Altitude;

/**
 * The range of heights that a vehicle may fly at on one leg of a predicted route.
 *
 * @param named nothing when it is not known how high it is
 */
public record LegHeights(List<Altitude> named, boolean toTheGround) {
    /** How far a height above home and one above the sea may be off each other. */
    private static final double CONVERSION_METERS = 0.5;

    /** In metres from one reference. */
    record Range(double lowMeters, double highMeters) {
        static final Range ANY = new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    public LegHeights {
        named = List.copyOf(named);
    }

    /** As seen from a reference; anything where that cannot be said. */
    Range from(Altitude.Reference reference, HeightReferences levels) {
        if (named.isEmpty()) {
            return Range.ANY;
        }
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (Altitude altitude : named) {
            Double meters = levels.bounded(altitude, reference);
            if (meters == null) {
                return Range.ANY;
            }
            double doubt = altitude.reference() == reference ? 0 : CONVERSION_METERS;
            low = Math.min(low, meters - doubt);
            high = Math.max(high, meters + doubt);
        }
        return new Range(toTheGround ? Double.NEGATIVE_INFINITY : low, high);
    }
}
