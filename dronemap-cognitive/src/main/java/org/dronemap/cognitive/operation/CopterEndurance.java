package org.dronemap.cognitive.operation;

/** Estimates from the battery how long a copter can stay in the air, and how long one on the ground takes to come. */
public final class CopterEndurance {
    /** That much is to be in the battery when it is home. */
    public static final int RESERVE_PERCENT = 20;

    /** In the air. */
    private static final double PERCENT_PER_SECOND = 5.0 / 60;
    /** On the way home. */
    private static final double METERS_PER_SECOND = 5;

    private CopterEndurance() {}

    /** What the way home takes, in per cent. */
    public static double percentBack(double homeMeters) {
        return homeMeters / METERS_PER_SECOND * PERCENT_PER_SECOND;
    }

    /** Until motors run and it rises. */
    private static final double START_SECONDS = 20;

    private static final double CLIMB_METERS_PER_SECOND = 2;

    /** Seconds that a drone on the ground takes to be at a place so far away, at that height above its home. */
    public static double secondsToCome(double meters, double heightMeters) {
        return START_SECONDS + heightMeters / CLIMB_METERS_PER_SECOND + secondsOfWay(meters);
    }

    /** Seconds that a drone in the air takes for a way of that length. */
    public static double secondsOfWay(double meters) {
        return meters / METERS_PER_SECOND;
    }

    /** Seconds until it has to fly home, if it stays about as far from there; 0: it has to. */
    public static double secondsLeft(int percent, double homeMeters) {
        return Math.max(0, (percent - RESERVE_PERCENT - percentBack(homeMeters)) / PERCENT_PER_SECOND);
    }
}
