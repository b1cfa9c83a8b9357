package org.dronemap.cognitive.cost;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;

/**
 * Map projection round a planning problem, in metres, that keeps straight lines of longitude and latitude straight.
 * Lengths on it are true near its origin only; {@link PlaceTable} knows true ones.
 */
final class EquirectangularPlane {
    private final Geodetic origin;
    private final double east;
    private final double north;

    EquirectangularPlane(Geodetic origin) {
        this.origin = origin;
        this.east = Ellipsoid.metersPerDegreeEast(origin.latitudeDegrees());
        this.north = Ellipsoid.metersPerDegreeNorth(origin.latitudeDegrees());
    }

    double x(Geodetic point) {
        return LocalPlane.eastward(origin, point) * east;
    }

    double x(double degreesEast) {
        return degreesEast * east;
    }

    double y(Geodetic point) {
        return (point.latitudeDegrees() - origin.latitudeDegrees()) * north;
    }

    Geodetic point(double x, double y) {
        double longitude = origin.longitudeDegrees() + x / east;
        return new Geodetic(origin.latitudeDegrees() + y / north, longitude - 360 * Math.rint(longitude / 360));
    }

    /** How much longer a metre of the chart's x is on the ground at that latitude. */
    double stretch(double latitudeDegrees) {
        return Ellipsoid.metersPerDegreeEast(latitudeDegrees) / east;
    }

    double stretchNorth(double latitudeDegrees) {
        return Ellipsoid.metersPerDegreeNorth(latitudeDegrees) / north;
    }

    /** From the origin along the meridian, on the ground. */
    double trueNorth(double latitudeDegrees) {
        return Ellipsoid.metersNorth(origin.latitudeDegrees(), latitudeDegrees);
    }
}
