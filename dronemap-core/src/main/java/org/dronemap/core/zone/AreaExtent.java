package org.dronemap.core.zone;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;

/**
 * Compares corners with a rectangle of longitude and latitude: a quick look that spares the close one where an outline
 * has hundreds of corners.
 */
final class AreaExtent {
    private AreaExtent() {}

    /**
     * Rectangle in degrees; east and west are measured from a place, the short way round.
     *
     * @param from where east and west are 0
     */
    record Box(Geodetic from, double south, double north, double west, double east) {
        static Box at(Geodetic point) {
            return new Box(point, point.latitudeDegrees(), point.latitudeDegrees(), 0, 0);
        }
    }

    /** Whether all of them lie on one side of it, so that what they enclose (less than 200 km wide) does not touch it. */
    static boolean isBeside(List<Geodetic> corners, Box box) {
        boolean south = true;
        boolean north = true;
        boolean west = true;
        boolean east = true;
        for (Geodetic corner : corners) {
            double away = LocalPlane.eastward(box.from(), corner);
            south &= corner.latitudeDegrees() < box.south();
            north &= corner.latitudeDegrees() > box.north();
            west &= away < box.west();
            east &= away > box.east();
            if (!(south || north || west || east)) {
                return false;
            }
        }
        return true;
    }
}
