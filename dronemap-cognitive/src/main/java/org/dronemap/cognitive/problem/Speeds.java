package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * The speeds and acceleration that a vehicle is planned with, in m/s and m/s²; it stops at each turn and waypoint.
 *
 * @param cruise over ground or through the air, as {@link WindResponse} says
 * @param landing in the last {@link #LANDING_METERS} over the ground
 * @param greatestAirspeed what it can fly against the wind at most, at least {@code cruise}
 * @param acceleration gathering speed and braking, in m/s²; infinite: at once
 */
@Stored(names = "cruise climb descent landing greatestAirspeed acceleration")
public record Speeds(
        double cruise, double climb, double descent, double landing, double greatestAirspeed, double acceleration) {
    /** So high over the ground a landing slows down. */
    public static final double LANDING_METERS = 10;

    private static final double LEAST = 0.1;
    private static final double MOST = 300;

    public Speeds {
        Require.within("cruise speed", cruise, LEAST, MOST);
        Require.within("climb speed", climb, LEAST, MOST);
        Require.within("descent speed", descent, LEAST, MOST);
        Require.within("landing speed", landing, LEAST, MOST);
        Require.within("greatest airspeed", greatestAirspeed, cruise, MOST);
        Require.positive("acceleration", acceleration);
    }

    public Speeds withCruise(double metersPerSecond) {
        return new Speeds(
                metersPerSecond, climb, descent, landing, Math.max(metersPerSecond, greatestAirspeed), acceleration);
    }
}
