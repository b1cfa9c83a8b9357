package org.dronemap.sim.load;

import java.util.Random;

/**
 * Load test: what the bad network does to each datagram; probabilities 0 to 1, times in ms.
 *
 * @param jitterMillis the delay is evenly spread over delay ± jitter, so that datagrams also overtake each other
 * @param reorder datagrams that are held back for two more delays
 */
record Impairment(double delayMillis, double jitterMillis, double loss, double duplicate, double reorder) {
    private static final double NANOS = 1e6;
    private static final double HELD_BACK_MILLIS = 20;

    Impairment {
        if (delayMillis < jitterMillis) {
            throw new IllegalArgumentException("the jitter cannot be more than the delay");
        }
        for (double chance : new double[] {loss, duplicate, reorder}) {
            if (!(chance >= 0 && chance <= 1)) {
                throw new IllegalArgumentException("a probability is 0 to 1: " + chance);
            }
        }
    }

    /** How many copies come through: 0, 1 or 2. */
    int copies(Random chance) {
        if (chance.nextDouble() < loss) {
            return 0;
        }
        return chance.nextDouble() < duplicate ? 2 : 1;
    }

    long delayNanos(Random chance) {
        double millis = delayMillis + jitterMillis * (2 * chance.nextDouble() - 1);
        if (chance.nextDouble() < reorder) {
            millis += Math.max(HELD_BACK_MILLIS, 2 * delayMillis);
        }
        return (long) (millis * NANOS);
    }
}
