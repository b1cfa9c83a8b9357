package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlaneSegment;

/** The space that a drone may be in during one step: above a line on the ground, between two heights above the sea. */
record OccupiedBox(PlanePoint from, PlanePoint to, double lowMeters, double highMeters) {
    static OccupiedBox at(PlanePoint place, double one, double other) {
        return new OccupiedBox(place, place, Math.min(one, other), Math.max(one, other));
    }

    /** As a share of what has to be kept: 1 is just enough. */
    double clearance(OccupiedBox other, double besideMeters, double aboveMeters) {
        double beside = new PlaneSegment(from, to).distanceMeters(new PlaneSegment(other.from, other.to));
        double above = Math.max(0, Math.max(lowMeters - other.highMeters, other.lowMeters - highMeters));
        return Math.max(beside / besideMeters, above / aboveMeters);
    }
}
