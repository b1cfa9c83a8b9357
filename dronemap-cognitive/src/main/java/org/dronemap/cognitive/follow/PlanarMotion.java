package org.dronemap.cognitive.follow;

import org.dronemap.core.geo.PlanePoint;

/**
 * Position, velocity and turn rate of a point on a local plane, in metres and m/s.
 *
 * @param turn radians a second, from east towards north
 */
public record PlanarMotion(double east, double north, double eastward, double northward, double turn) {
    static final PlanarMotion NONE = new PlanarMotion(0, 0, 0, 0, 0);
    private static final double STRAIGHT = 1e-4;

    PlanePoint spot() {
        return new PlanePoint(east, north);
    }

    double speed() {
        return Math.hypot(eastward, northward);
    }

    /** With a share of another one. */
    PlanarMotion plus(PlanarMotion other, double share) {
        return new PlanarMotion(
                east + share * other.east,
                north + share * other.north,
                eastward + share * other.eastward,
                northward + share * other.northward,
                turn + share * other.turn);
    }

    /** After a time of going on and turning as it does. */
    PlanarMotion after(double seconds) {
        double angle = turn * seconds;
        if (Math.abs(angle) < STRAIGHT) {
            return new PlanarMotion(east + eastward * seconds, north + northward * seconds, eastward, northward, turn);
        }
        double sine = Math.sin(angle);
        double cosine = Math.cos(angle);
        return new PlanarMotion(
                east + (sine * eastward - (1 - cosine) * northward) / turn,
                north + ((1 - cosine) * eastward + sine * northward) / turn,
                cosine * eastward - sine * northward,
                sine * eastward + cosine * northward,
                turn);
    }
}
