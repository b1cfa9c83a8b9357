package org.dronemap.core.cloud;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;

/** Picks how high one drone flies home so that its way crosses none of the others' at their height. All in metres. */
final class ReturnHeightChoice {
    static final double APART_METERS = 5;
    static final double NEAR_METERS = 2_000;
    private static final double HIGHEST_METERS = 120;
    /** What was computed of several sums is not taken for nearer for a rounding. */
    private static final double ROUNDING = 1e-6;

    private ReturnHeightChoice() {}

    /**
     * What its owner has set, or the next one above in steps, that is free and allowed; empty when there is none.
     *
     * @param owners above home; 0: as high as it is then, where it is alone
     * @param taken of the others, above this drone's own ground
     */
    static OptionalDouble of(double owners, List<Double> taken, DoublePredicate allowed) {
        if (taken.isEmpty() || (owners > 0 && isFree(owners, taken))) {
            return OptionalDouble.of(owners);
        }
        for (double height = owners + APART_METERS; height <= HIGHEST_METERS; height += APART_METERS) {
            if (isFree(height, taken) && allowed.test(height)) {
                return OptionalDouble.of(height);
            }
        }
        return OptionalDouble.empty();
    }

    private static boolean isFree(double height, List<Double> taken) {
        return taken.stream().allMatch(other -> Math.abs(other - height) >= APART_METERS - ROUNDING);
    }
}
