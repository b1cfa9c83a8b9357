package org.dronemap.core.mission;

/** An altitude in metres that carries what it is measured from, so that no home is needed to plan. */
public record Altitude(double meters, Reference reference) {
    /** What zero is. */
    public enum Reference {
        /** The vehicle's home position. */
        HOME,
        /** Mean sea level. */
        AMSL
    }

    public Altitude {
        if (!(Math.abs(meters) <= 10_000)) {
            throw new IllegalArgumentException("altitude must be -10000 to 10000 m: " + meters);
        }
    }

    public static Altitude aboveHome(double meters) {
        return new Altitude(meters, Reference.HOME);
    }
}
