package org.dronemap.core.geo;

/** A point of a {@link LocalPlane}: metres to the east and to the north of its origin. */
public record PlanePoint(double eastMeters, double northMeters) {
    public double distanceMeters(PlanePoint other) {
        return Math.hypot(eastMeters - other.eastMeters, northMeters - other.northMeters);
    }
}
