package org.dronemap.core.mission;

import org.dronemap.core.stored.Stored;

/** An altitude in metres with its reference: above home or above mean sea level. */
@Stored(names = "meters reference")
public record Altitude(double meters, Reference reference) {
    /** Zero level of an altitude: the home position or mean sea level. */
    @Stored(names = "HOME AMSL")
    public enum Reference {
        /** The vehicle's home position. */
        HOME,
        /** Mean sea level. */
        AMSL
    }

    /** Lowest that may be planned: under any shore, or any valley below a take-off place; more is a slip of the hand. */
    public static final int LOWEST_PLANNED_METERS = -500;

    /** Highest that may be planned: above all that is flown from here. */
    public static final int HIGHEST_PLANNED_METERS = 10_000;

    /** What was found on a vehicle may lie outside what may be planned. */
    public Altitude {
        if (!(Math.abs(meters) <= 10_000)) {
            throw new IllegalArgumentException("altitude must be -10000 to 10000 m: " + meters);
        }
    }

    public static Altitude aboveHome(double meters) {
        return new Altitude(meters, Reference.HOME);
    }
}
