package org.dronemap.cognitive.cost;

/** Lengths along parallels and meridians of the WGS-84 ellipsoid. */
final class Ellipsoid {
    private static final double EQUATOR_METERS = 6_378_137.0;
    private static final double ECCENTRICITY_SQUARED = 0.006_694_379_990_14;

    private Ellipsoid() {}

    /** One degree of longitude. */
    static double metersPerDegreeEast(double latitudeDegrees) {
        double latitude = Math.toRadians(latitudeDegrees);
        double sine = Math.sin(latitude);
        return Math.toRadians(EQUATOR_METERS * Math.cos(latitude) / Math.sqrt(1 - ECCENTRICITY_SQUARED * sine * sine));
    }

    /** One degree of latitude. */
    static double metersPerDegreeNorth(double latitudeDegrees) {
        double sine = Math.sin(Math.toRadians(latitudeDegrees));
        double squared = 1 - ECCENTRICITY_SQUARED * sine * sine;
        return Math.toRadians(EQUATOR_METERS * (1 - ECCENTRICITY_SQUARED) / (squared * Math.sqrt(squared)));
    }

    /** Along a meridian, by Simpson's rule. */
    static double metersNorth(double fromDegrees, double toDegrees) {
        double ends = metersPerDegreeNorth(fromDegrees) + metersPerDegreeNorth(toDegrees);
        return (toDegrees - fromDegrees) * (ends + 4 * metersPerDegreeNorth((fromDegrees + toDegrees) / 2)) / 6;
    }
}
