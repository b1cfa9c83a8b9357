package org.dronemap.sim.physics;

import java.util.SplittableRandom;

/**
 * The wind of a simulated vehicle: a mean wind plus gusts of a few seconds, repeatable by its seed. Owned by its
 * vehicle.
 */
public final class WindModel {
    private static final double GUST_SHARE = 0.25;
    private static final double GUST_SECONDS = 3.0;

    private final SplittableRandom random;
    private final double meanNorth;
    private final double meanEast;
    private final double gustSpeed;
    private double gustNorth;
    private double gustEast;

    public WindModel(double meanSpeed, double towardsRadians, long seed) {
        this.random = new SplittableRandom(seed);
        this.meanNorth = meanSpeed * Math.cos(towardsRadians);
        this.meanEast = meanSpeed * Math.sin(towardsRadians);
        this.gustSpeed = meanSpeed * GUST_SHARE;
    }

    public void step(double seconds) {
        if (gustSpeed == 0) {
            return;
        }
        double keep = Math.exp(-seconds / GUST_SECONDS);
        double fresh = gustSpeed * Math.sqrt(1 - keep * keep);
        gustNorth = gustNorth * keep + fresh * random.nextGaussian();
        gustEast = gustEast * keep + fresh * random.nextGaussian();
    }

    public double north() {
        return meanNorth + gustNorth;
    }

    public double east() {
        return meanEast + gustEast;
    }

    double gustNorth() {
        return gustNorth;
    }

    double gustEast() {
        return gustEast;
    }
}
