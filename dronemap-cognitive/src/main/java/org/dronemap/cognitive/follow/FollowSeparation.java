package org.dronemap.cognitive.follow;

/** The least separation of following drones from all other drones: horizontal or vertical, in metres. */
public record FollowSeparation(double groundMeters, double heightMeters) {
    /** Less cannot be kept over a network that is slow and loses: one in two hundred trials with 5 m fell short by up to 3 m. */
    public static final double LEAST_GROUND_METERS = 8;

    public static final double MOST_GROUND_METERS = 50;
    public static final double LEAST_HEIGHT_METERS = 3;
    public static final double MOST_HEIGHT_METERS = 30;

    public static final FollowSeparation USUAL = new FollowSeparation(10, 5);

    public FollowSeparation {
        if (!(groundMeters >= LEAST_GROUND_METERS && groundMeters <= MOST_GROUND_METERS)) {
            throw new IllegalArgumentException("a separation on the ground is " + LEAST_GROUND_METERS + " to "
                    + MOST_GROUND_METERS + " metres: " + groundMeters);
        }
        if (!(heightMeters >= LEAST_HEIGHT_METERS && heightMeters <= MOST_HEIGHT_METERS)) {
            throw new IllegalArgumentException("a separation in height is " + LEAST_HEIGHT_METERS + " to "
                    + MOST_HEIGHT_METERS + " metres: " + heightMeters);
        }
    }
}
