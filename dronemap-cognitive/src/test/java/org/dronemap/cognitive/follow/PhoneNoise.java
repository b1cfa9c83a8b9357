package org.dronemap.cognitive.follow;

import java.util.SplittableRandom;

/** The error of a phone's receiver: one that wanders (Gauss–Markov) and one that is new each time, in metres an axis. */
final class PhoneNoise {
    static final double WANDERING_METERS = 3;
    private static final double WANDERING_SECONDS = 60;
    private static final double WHITE_METERS = 0.5;

    private static final double SPEED_METERS = 0.3;

    private final SplittableRandom random;
    private final boolean on;
    private double east;
    private double north;
    private boolean begun;

    PhoneNoise(long seed, boolean on) {
        random = new SplittableRandom(seed);
        this.on = on;
    }

    /** Of the next fix, so much later. */
    double[] next(double seconds) {
        if (!on) {
            return new double[] {0, 0};
        }
        double keep = begun ? Math.exp(-seconds / WANDERING_SECONDS) : 0;
        double fresh = WANDERING_METERS * Math.sqrt(1 - keep * keep);
        east = east * keep + fresh * random.nextGaussian();
        north = north * keep + fresh * random.nextGaussian();
        begun = true;
        return new double[] {east + WHITE_METERS * random.nextGaussian(), north + WHITE_METERS * random.nextGaussian()};
    }

    /** How it moves, as the receiver measures it. */
    PhoneFix.Course course(double eastward, double northward) {
        double east = eastward + SPEED_METERS * random.nextGaussian();
        double north = northward + SPEED_METERS * random.nextGaussian();
        return new PhoneFix.Course(Math.hypot(east, north), Math.toDegrees(Math.atan2(east, north)));
    }
}
