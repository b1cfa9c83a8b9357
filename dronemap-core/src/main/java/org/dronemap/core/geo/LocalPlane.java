package org.dronemap.core.geo;

import java.util.List;

/**
 * Projects positions around an origin to a plane in metres. Straight lines of longitude and latitude stay straight, so
 * that what crosses on the map crosses here; lengths are true near the origin's latitude (WGS-84).
 */
public final class LocalPlane {
    private static final double EQUATOR_METERS = 6_378_137.0;
    private static final double ECCENTRICITY_SQUARED = 0.006_694_379_990_14;

    private final Geodetic origin;
    private final double metersPerDegreeEast;
    private final double metersPerDegreeNorth;

    public LocalPlane(Geodetic origin) {
        this(origin, origin.latitudeDegrees());
    }

    private LocalPlane(Geodetic origin, double trueLatitudeDegrees) {
        double latitude = Math.toRadians(trueLatitudeDegrees);
        double sine = Math.sin(latitude);
        double squared = 1 - ECCENTRICITY_SQUARED * sine * sine;
        double acrossMeters = EQUATOR_METERS / Math.sqrt(squared);
        double alongMeters = acrossMeters * (1 - ECCENTRICITY_SQUARED) / squared;
        this.origin = origin;
        this.metersPerDegreeEast = Math.toRadians(acrossMeters * Math.cos(latitude));
        this.metersPerDegreeNorth = Math.toRadians(alongMeters);
    }

    /** Where a place is seen from another one: the distance is right within 1 in 100,000 up to 100 km. */
    public static PlanePoint offset(Geodetic from, Geodetic to) {
        double middle = (from.latitudeDegrees() + to.latitudeDegrees()) / 2;
        return new LocalPlane(from, middle).spot(to);
    }

    /** A place, on the side of the date line that is nearer to the origin. */
    public PlanePoint spot(Geodetic place) {
        return spot(origin.longitudeDegrees() + eastward(origin, place), place.latitudeDegrees());
    }

    /** The place that a point of the plane stands for, for points some kilometres away at most. */
    public Geodetic place(PlanePoint spot) {
        double latitude = origin.latitudeDegrees() + spot.northMeters() / metersPerDegreeNorth;
        double longitude = origin.longitudeDegrees() + spot.eastMeters() / metersPerDegreeEast;
        return new Geodetic(Math.max(-90, Math.min(90, latitude)), Math.IEEEremainder(longitude, 360));
    }

    private PlanePoint spot(double longitudeDegrees, double latitudeDegrees) {
        return new PlanePoint(
                (longitudeDegrees - origin.longitudeDegrees()) * metersPerDegreeEast,
                (latitudeDegrees - origin.latitudeDegrees()) * metersPerDegreeNorth);
    }

    /** An area, kept in one piece where the date line runs through it; its first corner decides on the side. */
    public PlanePolygon outline(List<Geodetic> corners) {
        Geodetic first = corners.get(0);
        double longitude = origin.longitudeDegrees() + eastward(origin, first);
        return new PlanePolygon(corners.stream()
                .map(corner -> spot(longitude + eastward(first, corner), corner.latitudeDegrees()))
                .toList());
    }

    /** Degrees of longitude from one place to another the short way round. */
    public static double eastward(Geodetic from, Geodetic to) {
        double degrees = to.longitudeDegrees() - from.longitudeDegrees();
        if (degrees > 180) {
            return degrees - 360;
        }
        return degrees < -180 ? degrees + 360 : degrees;
    }
}
