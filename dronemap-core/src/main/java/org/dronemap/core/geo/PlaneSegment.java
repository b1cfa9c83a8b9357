package org.dronemap.core.geo;

/** A line segment on a LocalPlane; both ends may be the same point. */
public record PlaneSegment(PlanePoint from, PlanePoint to) {
    public double lengthMeters() {
        return from.distanceMeters(to);
    }

    /** The spot at a share of the way, 0 to 1. */
    public PlanePoint at(double share) {
        return new PlanePoint(
                from.eastMeters() + share * (to.eastMeters() - from.eastMeters()),
                from.northMeters() + share * (to.northMeters() - from.northMeters()));
    }

    public double distanceMeters(PlanePoint spot) {
        return spot.distanceMeters(at(nearestShare(spot)));
    }

    /** The share of the way at which it is nearest to a spot. */
    public double nearestShare(PlanePoint spot) {
        double east = to.eastMeters() - from.eastMeters();
        double north = to.northMeters() - from.northMeters();
        double squared = east * east + north * north;
        if (squared == 0) {
            return 0;
        }
        double along =
                (spot.eastMeters() - from.eastMeters()) * east + (spot.northMeters() - from.northMeters()) * north;
        return Math.max(0, Math.min(1, along / squared));
    }

    /** 0 when they cross or touch. */
    public double distanceMeters(PlaneSegment other) {
        if (crosses(other)) {
            return 0;
        }
        return Math.min(
                Math.min(distanceMeters(other.from), distanceMeters(other.to)),
                Math.min(other.distanceMeters(from), other.distanceMeters(to)));
    }

    /** Both ends of each lie on different sides of the other. What only touches, or nearly, is a matter of distance. */
    public boolean crosses(PlaneSegment other) {
        return side(other.from) * side(other.to) < 0 && other.side(from) * other.side(to) < 0;
    }

    /** The share of the way at which a stretch that crosses this one is met. */
    public double crossingShare(PlaneSegment other) {
        double before = other.side(from);
        double after = other.side(to);
        return before / (before - after);
    }

    /** Positive to the left of the line, negative to the right: twice the area of the triangle. */
    private double side(PlanePoint spot) {
        return (to.eastMeters() - from.eastMeters()) * (spot.northMeters() - from.northMeters())
                - (to.northMeters() - from.northMeters()) * (spot.eastMeters() - from.eastMeters());
    }
}
