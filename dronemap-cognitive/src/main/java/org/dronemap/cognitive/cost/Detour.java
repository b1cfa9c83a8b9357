package org.dronemap.cognitive.cost;

import java.util.Arrays;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * The shortest allowed path between two places: its turns, and its costs by drone type. Immutable, so that threads may
 * find it twice and pass it on as they like.
 *
 * @param turns nothing for a straight way
 * @param costs of each type that may fly it; null where the straight way is free
 */
record Detour(
        int from, int to, List<Geodetic> turns, @Nullable CostsByType costs) {
    /** Of each type, by its number. */
    static final class CostsByType {
        final double meters;
        final double[] seconds;
        final double[] joules;

        CostsByType(double meters, double[] seconds, double[] joules) {
            this.meters = meters;
            this.seconds = seconds;
            this.joules = joules;
        }

        static CostsByType unreachable(int types) {
            double[] never = new double[types];
            Arrays.fill(never, Double.POSITIVE_INFINITY);
            return new CostsByType(Double.POSITIVE_INFINITY, never, never);
        }
    }
}
