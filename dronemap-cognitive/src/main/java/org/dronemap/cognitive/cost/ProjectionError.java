package org.dronemap.cognitive.cost;

/**
 * An upper bound on how far straight lines on map, globe and plane differ over the length of a leg.
 *
 * @param factor times the square of a length in metres
 */
record ProjectionError(double factor) {
    /** What the gate asks for beside all legs, rounding included. */
    private static final double LEAST_METERS = 0.35;
    /** The chart's scale is not true everywhere. */
    private static final double ALLOWANCE = 1.05;

    private static final double MEAN_EARTH_RADIUS_METERS = 6_371_008.8;

    static ProjectionError at(double steepestDegrees) {
        return new ProjectionError(
                ALLOWANCE * Math.tan(Math.toRadians(Math.abs(steepestDegrees))) / (8 * MEAN_EARTH_RADIUS_METERS));
    }

    double meters(double length) {
        return factor * length * length;
    }

    /** What a leg of that length needs beside it. */
    double room(double length) {
        return LEAST_METERS + meters(length);
    }
}
