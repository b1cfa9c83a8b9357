package org.dronemap.core.history;

import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Computes the totals of a flight from its states one by one. Owned by whoever made it. */
final class FlightStatisticsBuilder {
    /** Shorter ways are the noise of a satellite receiver on the ground. */
    private static final double STEP_METERS = 1;

    private FlightStatistics measures;
    private @Nullable Geodetic counted;

    /** Goes on from what is known. */
    FlightStatisticsBuilder(FlightStatistics known) {
        this.measures = known;
        this.counted = known.last();
    }

    void add(TelemetryPoint point) {
        Geodetic place = point.position() == null ? null : point.position().point();
        measures = measures.with(point);
        if (place == null) {
            return;
        }
        double way = counted == null ? 0 : Geodesy.distanceMeters(counted, place);
        if (counted == null || way >= STEP_METERS) {
            counted = place;
            measures = measures.andFlown(way);
        }
    }

    FlightStatistics measures() {
        return measures;
    }
}
