package org.dronemap.sim.physics;

import java.util.SplittableRandom;

/**
 * Errors of a simulated vehicle about its place: a slow wandering over ground as of a GPS receiver, a height that
 * drifts as a barometer does. Repeatable by its seed; metres. Owned by its vehicle.
 */
public final class SensorNoise {
    /** What the receiver says of itself: two in three times it is nearer than that. */
    public static final double DECLARED_HORIZONTAL = 1.5;

    public static final double DECLARED_VERTICAL = 2.5;

    /** Each of north and east; together two in three are within what is declared. */
    private static final double WANDER_METERS = 1.0;

    private static final double WANDER_SECONDS = 60;
    private static final double JITTER_METERS = 0.3;
    private static final double DRIFT_METERS = 1;
    private static final double DRIFT_SECONDS = 600;
    private static final double HOME_METERS = 5;

    private final boolean on;
    private final SplittableRandom random;
    private final double driftPerSecond;
    private final double homeOffset;
    private double north;
    private double east;
    private double height;

    private SensorNoise(boolean on, long seed) {
        this.on = on;
        this.random = new SplittableRandom(seed);
        this.driftPerSecond = (random.nextBoolean() ? DRIFT_METERS : -DRIFT_METERS) / DRIFT_SECONDS;
        this.homeOffset = on ? random.nextDouble(-HOME_METERS, HOME_METERS) : 0;
    }

    public static SensorNoise none() {
        return new SensorNoise(false, 0);
    }

    public static SensorNoise of(long seed) {
        return new SensorNoise(true, seed);
    }

    public boolean on() {
        return on;
    }

    public void step(double seconds) {
        if (!on) {
            return;
        }
        double keep = Math.exp(-seconds / WANDER_SECONDS);
        double fresh = WANDER_METERS * Math.sqrt(1 - keep * keep);
        north = north * keep + fresh * random.nextGaussian();
        east = east * keep + fresh * random.nextGaussian();
        height += driftPerSecond * seconds;
    }

    /** By so much it takes its home for higher than it is. */
    public double homeOffset() {
        return homeOffset;
    }

    /** The height that it measures on the ground where it was switched on. */
    public double height() {
        return height;
    }

    /** Where it truly is when it believes to be there. */
    public NeuPosition truth(NeuPosition believed) {
        return new NeuPosition(believed.north() - north, believed.east() - east, believed.up() - height);
    }

    /** Where its receiver alone would have it. */
    public NeuPosition received(NeuPosition believed) {
        if (!on) {
            return believed;
        }
        return new NeuPosition(
                believed.north() + JITTER_METERS * random.nextGaussian(),
                believed.east() + JITTER_METERS * random.nextGaussian(),
                believed.up() + JITTER_METERS * random.nextGaussian());
    }
}
