package org.dronemap.ws.reading;

import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Checks numbers that clients wrote, such as latitudes, against the range allowed for their field. */
public final class FieldRanges {
    /** Degrees, on either side of the equator. */
    public static final int LATITUDE = 90;
    /** Degrees, on either side of Greenwich. */
    public static final int LONGITUDE = 180;
    /** Metres above home, up to which a drone takes off. */
    public static final int LEAST_TAKE_OFF = 1;

    public static final int MOST_TAKE_OFF = 500;
    /** Degrees, either way. */
    public static final int MOST_TURN = 360;
    /** Metres a second, of any kind of vehicle. */
    public static final String LEAST_SPEED = "" + ChangeSpeed.SLOWEST;

    public static final int MOST_SPEED = 100;
    /** Metres, either way. */
    public static final int MOST_ON_MAP = 100_000;

    public static final int LAST_RELAY = 15;
    /** Seconds that a drone stays somewhere. */
    public static final int MOST_SECONDS = 3600;
    /** Metres of a circle. */
    public static final int LEAST_RADIUS = 1;

    public static final int MOST_RADIUS = 100_000;
    private static final double LEAST_WAIT_SECONDS = 0.1;

    private FieldRanges() {}

    public static double latitude(String field, @Nullable Double value) {
        return checked(field, value, -LATITUDE, LATITUDE, "degrees");
    }

    public static double longitude(String field, @Nullable Double value) {
        return checked(field, value, -LONGITUDE, LONGITUDE, "degrees");
    }

    /** {@code at} is what stands before the names of its fields, such as {@code center.}. */
    public static Geodetic point(String at, @Nullable Double latitude, @Nullable Double longitude) {
        return new Geodetic(latitude(at + "latitude", latitude), longitude(at + "longitude", longitude));
    }

    public static double takeOffAltitude(String field, @Nullable Double value) {
        return checked(field, value, LEAST_TAKE_OFF, MOST_TAKE_OFF, "m");
    }

    public static double altitude(String field, @Nullable Double value) {
        return checked(field, value, Altitude.LOWEST_PLANNED_METERS, Altitude.HIGHEST_PLANNED_METERS, "m");
    }

    public static double turn(String field, @Nullable Double value) {
        double degrees = checked(field, value, -MOST_TURN, MOST_TURN, "degrees");
        if (degrees == 0) {
            throw outside(field, "-360 to 360 degrees, not 0", degrees, -360, 360, "degrees");
        }
        return degrees;
    }

    /** What each kind of vehicle takes of these is for the gate to say. */
    public static double speed(String field, @Nullable Double value) {
        double speed = checked(field, value, 0, MOST_SPEED, "m/s");
        if (speed < ChangeSpeed.SLOWEST) {
            throw outside(field, "0.1 to 100 m/s", speed, ChangeSpeed.SLOWEST, MOST_SPEED, "m/s");
        }
        return speed;
    }

    /** Metres on a map of a vehicle's own. */
    public static double onMap(String field, @Nullable Double value) {
        return checked(field, value, -MOST_ON_MAP, MOST_ON_MAP, "m");
    }

    public static int relay(String field, @Nullable Integer value) {
        return checked(field, value, 0, LAST_RELAY, "");
    }

    public static double holdSeconds(String field, double value) {
        return checked(field, value, 0, MOST_SECONDS, "seconds");
    }

    /** Less would be waiting for a time of day. */
    public static double waitSeconds(String field, @Nullable Double value) {
        double seconds = checked(field, value, 0, MOST_SECONDS, "seconds");
        if (seconds < LEAST_WAIT_SECONDS) {
            throw outside(field, "0.1 to 3600 seconds", seconds, LEAST_WAIT_SECONDS, 3600, "seconds");
        }
        return seconds;
    }

    /** Of a circle, in metres. */
    public static double radius(String field, @Nullable Double value) {
        return checked(field, value, LEAST_RADIUS, MOST_RADIUS, "m");
    }

    /** Of a circle of a vehicle's own fence, in metres: down to a centimetre, as vehicles keep them. */
    public static double fenceRadius(String field, @Nullable Double value) {
        String allowed = "0.01 to 100000 m";
        if (value == null) {
            throw InvalidInput.missing(field, allowed);
        }
        if (!(value >= FenceArea.Circle.LEAST_RADIUS_METERS && value <= MOST_RADIUS)) {
            throw outside(field, allowed, value, FenceArea.Circle.LEAST_RADIUS_METERS, MOST_RADIUS, "m");
        }
        return value;
    }

    public static int output(String field, @Nullable Integer value) {
        return checked(field, value, 1, MissionItem.SetServo.MOST_OUTPUTS, "");
    }

    public static int pulse(String field, @Nullable Integer value) {
        return checked(
                field,
                value,
                MissionItem.SetServo.SHORTEST_MICROS,
                MissionItem.SetServo.LONGEST_MICROS,
                " microseconds");
    }

    public static int checked(String field, @Nullable Integer value, int least, int most, String unit) {
        String allowed = least + " to " + most + unit;
        if (value == null) {
            throw InvalidInput.missing(field, allowed);
        }
        if (value < least || value > most) {
            throw outside(field, allowed, value, least, most, unit);
        }
        return value;
    }

    public static double checked(String field, @Nullable Double value, int least, int most, String unit) {
        String allowed = least + " to " + most + " " + unit;
        if (value == null) {
            throw InvalidInput.missing(field, allowed);
        }
        if (!(value >= least && value <= most)) {
            throw outside(field, allowed, value, least, most, unit);
        }
        return value;
    }

    private static InvalidInput outside(
            String field, String allowed, Object value, double least, int most, String unit) {
        ProblemParameter.Given from = ProblemParameter.LEAST.is(least);
        ProblemParameter.Given to = ProblemParameter.MOST.is(most);
        return unit.isEmpty()
                ? InvalidInput.outside(ValueProblem.VALUE_OUT_OF_RANGE, field, allowed, value, from, to)
                : InvalidInput.outside(
                        ValueProblem.VALUE_OUT_OF_RANGE,
                        field,
                        allowed,
                        value,
                        from,
                        to,
                        ProblemParameter.UNIT.is(unit.strip()));
    }
}
