package org.dronemap.core.separation;

import org.dronemap.core.stored.Stored;

/**
 * The least separation of two drones in the air: horizontal or vertical, in metres. Heights count between drones whose
 * homes are known to be level (see {@link VerticalMargin}).
 *
 * @param horizontalMeters 0 to 10,000
 * @param verticalMeters 0 to 1,000
 */
@Stored(names = "horizontalMeters verticalMeters")
public record Separation(double horizontalMeters, double verticalMeters) {
    public static final Separation USUAL = new Separation(10, 5);
    /** Less cannot be kept over a network that is slow and loses: one in two hundred trials with 5 m fell short by up to 3 m. */
    public static final double LEAST_HORIZONTAL_METERS = 8;

    public static final double MOST_HORIZONTAL_METERS = 50;
    public static final double LEAST_VERTICAL_METERS = 3;
    public static final double MOST_VERTICAL_METERS = 30;

    private static final double AIMED_BEYOND_METERS = 5;

    public Separation {
        require("horizontalMeters", horizontalMeters, 10_000);
        require("verticalMeters", verticalMeters, 1_000);
    }

    private static void require(String name, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException(name + " must be 0 to " + most + ": " + value);
        }
    }

    /** What is planned with, and looked out for: how drones gather speed and brake is not known to the metre. */
    public Separation aimedFor() {
        return plus(AIMED_BEYOND_METERS, 0);
    }

    /** The same with more room both ways. */
    Separation plus(double horizontal, double vertical) {
        return new Separation(horizontalMeters + horizontal, verticalMeters + vertical);
    }
}
