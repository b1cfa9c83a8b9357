package org.dronemap.proxy.session;

import org.jspecify.annotations.Nullable;

/** The mean of measured values with exponentially falling weight of old ones. Owned by whoever measures. */
final class AgingMean {
    private static final double FEWEST_VALUES = 3;

    private final double memorySeconds;
    private double sum;
    private double weight;

    AgingMean(double memorySeconds) {
        this.memorySeconds = memorySeconds;
    }

    /** {@code seconds}: since the value before. */
    void add(double value, double seconds) {
        double kept = Math.exp(-Math.max(0, seconds) / memorySeconds);
        sum = sum * kept + value;
        weight = weight * kept + 1;
    }

    /** Null while too few were measured to tell. */
    @Nullable
    Double mean() {
        return weight < FEWEST_VALUES ? null : (Double) (sum / weight);
    }
}
