package org.dronemap.cognitive.follow;

import org.dronemap.core.geo.Spot;

/**
 * Position, velocity and turn rate of a point on a local plane, in metres and m/s.
 *
 * @param turn radians a second, from east towards north
 */
public record Motion(double east, double north, double eastward, double northward, double turn) {
    static final Motion NONE = new Motion(0, 0, 0, 0, 0);
    private static final double STRAIGHT = 1e-4;

    Spot spot() {
        return new Spot(east, north);
    }

    double speed() {
        return Math.hypot(eastward, northward);
    }

    /** With a share of another one. */
    Motion plus(Motion other, double share) {
        return new Motion(
                east + share * other.east,
                north + share * other.north,
                eastward + share * other.eastward,
                northward + share * other.northward,
                turn + share * other.turn);
    }

    /** After a time of going on and turning as it does. */
    Motion after(double seconds) {
        double angle = turn * seconds;
        if (Math.abs(angle) < STRAIGHT) {
            return new Motion(east + eastward * seconds, north + northward * seconds, eastward, northward, turn);
        }
        double sine = Math.sin(angle);
        double cosine = Math.cos(angle);
        return new Motion(
                east + (sine * eastward - (1 - cosine) * northward) / turn,
                north + ((1 - cosine) * eastward + sine * northward) / turn,
                cosine * eastward - sine * northward,
                sine * eastward + cosine * northward,
                turn);
    }
}
