package org.dronemap.core.geo;

/** Distances and bearings on a sphere of the mean Earth radius: within 0.6 % of the ellipsoid, enough below 100 km. */
public final class Geodesy {
    private static final double MEAN_EARTH_RADIUS_METERS = 6_371_008.8;

    private Geodesy() {}

    /** Great-circle distance in metres (haversine, stable for short distances). */
    public static double distanceMeters(Geodetic from, Geodetic to) {
        double latitudeFrom = Math.toRadians(from.latitudeDegrees());
        double latitudeTo = Math.toRadians(to.latitudeDegrees());
        double halfLatitude = (latitudeTo - latitudeFrom) / 2;
        double halfLongitude = Math.toRadians(to.longitudeDegrees() - from.longitudeDegrees()) / 2;
        double sinLatitude = Math.sin(halfLatitude);
        double sinLongitude = Math.sin(halfLongitude);
        double a =
                sinLatitude * sinLatitude + Math.cos(latitudeFrom) * Math.cos(latitudeTo) * sinLongitude * sinLongitude;
        return 2 * MEAN_EARTH_RADIUS_METERS * Math.asin(Math.min(1, Math.sqrt(a)));
    }

    /** Initial bearing in degrees, 0 (north) to 360 clockwise. */
    public static double bearingDegrees(Geodetic from, Geodetic to) {
        double latitudeFrom = Math.toRadians(from.latitudeDegrees());
        double latitudeTo = Math.toRadians(to.latitudeDegrees());
        double longitude = Math.toRadians(to.longitudeDegrees() - from.longitudeDegrees());
        double y = Math.sin(longitude) * Math.cos(latitudeTo);
        double x = Math.cos(latitudeFrom) * Math.sin(latitudeTo)
                - Math.sin(latitudeFrom) * Math.cos(latitudeTo) * Math.cos(longitude);
        return (Math.toDegrees(Math.atan2(y, x)) + 360) % 360;
    }
}
