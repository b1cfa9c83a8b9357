package org.dronemap.core.cloud.rule;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;

/**
 * Chooses a height at which one drone flies home without meeting other drones flying home; in metres. All in metres.
 */
public final class ReturnHeightChoice {
    static final double APART_METERS = 5;
    public static final double NEAR_METERS = 2_000;
    /**
     * Who flies above its return height comes home as high as it flies (ArduCopter's RTL_ALT, PX4's RTL_RETURN_ALT): those
     * that are not alone get theirs above the heights of most flights.
     */
    static final double USUALLY_FLOWN_METERS = 30;

    private static final double HIGHEST_METERS = 120;
    /** What was computed of several sums is not taken for nearer for a rounding. */
    private static final double ROUNDING = 1e-6;

    private ReturnHeightChoice() {}

    /**
     * The height that its owner has set where it is alone, or where that is free and above what is usually flown; else the lowest height
     * from there on, in steps, that is free and allowed, and only then one below; empty when there is none.
     *
     * @param owners above home; 0: as high as it is then, where it is alone
     * @param taken of the others, above this drone's own ground
     */
    public static OptionalDouble of(double owners, List<Double> taken, DoublePredicate allowed) {
        boolean isHigh = owners >= USUALLY_FLOWN_METERS;
        if (taken.isEmpty() || (isHigh && isFree(owners, taken))) {
            return OptionalDouble.of(owners);
        }
        double lowest = isHigh ? owners + APART_METERS : USUALLY_FLOWN_METERS;
        OptionalDouble above = lowest(lowest, HIGHEST_METERS, taken, allowed);
        if (above.isPresent() || isHigh) {
            return above;
        }
        return owners > 0 && isFree(owners, taken)
                ? OptionalDouble.of(owners)
                : lowest(owners + APART_METERS, USUALLY_FLOWN_METERS, taken, allowed);
    }

    private static OptionalDouble lowest(double from, double to, List<Double> taken, DoublePredicate allowed) {
        for (double height = from; height <= to; height += APART_METERS) {
            if (isFree(height, taken) && allowed.test(height)) {
                return OptionalDouble.of(height);
            }
        }
        return OptionalDouble.empty();
    }

    /** Whether two that fly home at those heights pass each other in safety. */
    public static boolean areApart(double one, double other) {
        return Math.abs(other - one) >= APART_METERS - ROUNDING;
    }

    private static boolean isFree(double height, List<Double> taken) {
        return taken.stream().allMatch(other -> areApart(height, other));
    }
}
