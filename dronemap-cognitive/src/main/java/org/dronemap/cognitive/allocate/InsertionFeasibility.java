package org.dronemap.cognitive.allocate;

import org.jspecify.annotations.Nullable;

/** Decides whether a waypoint fits into a drone's tour by skills, battery and time windows. */
final class InsertionFeasibility {
    private static final double ROUNDING = 1e-9;

    private final TourLists tours;
    private final LegCosts costs;

    InsertionFeasibility(TourLists tours, LegCosts costs) {
        this.tours = tours;
        this.costs = costs;
    }

    /** Without windows. */
    boolean fits(int r, int after, int waypoint) {
        return !costs.limited()
                || withinRange(costs, r, tours.joules(r) + costs.moreJoules(r, after, waypoint, tours.next(after)));
    }

    /** With windows only the whole tour tells: the tour with the waypoint in it, or null when it cannot be flown. */
    @Nullable
    TourEvaluation flown(int r, int after, int waypoint) {
        TourEvaluation flight = new TourEvaluation(costs, r);
        int end = tours.end(r);
        int place = tours.start(r);
        while (place != end && !flight.late()) {
            if (place == after) {
                flight.fly(place, waypoint);
                flight.fly(waypoint, tours.next(place));
            } else {
                flight.fly(place, tours.next(place));
            }
            place = tours.next(place);
        }
        return flight.late() || !withinRange(costs, r, flight.joules()) ? null : flight;
    }

    static boolean withinRange(LegCosts costs, int r, double joules) {
        double range = costs.rangeJoules(r);
        return joules <= range + ROUNDING * Math.abs(range);
    }
}
