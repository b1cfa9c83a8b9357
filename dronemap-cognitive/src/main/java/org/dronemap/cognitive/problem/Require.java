package org.dronemap.cognitive.problem;

import java.util.Locale;

/** Range checks for values of planning problems; their messages name the field and the range. */
final class Require {
    private Require() {}

    static double within(String field, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new IllegalArgumentException(
                    field + " must be " + number(least) + " to " + number(most) + ": " + number(value));
        }
        return value;
    }

    /** Infinite is allowed: no limit. */
    static double positive(String field, double value) {
        if (!(value > 0)) {
            throw new IllegalArgumentException(field + " must be above 0: " + number(value));
        }
        return value;
    }

    static double notNegative(String field, double value) {
        if (!(value >= 0)) {
            throw new IllegalArgumentException(field + " must be at least 0: " + number(value));
        }
        return value;
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? String.format(Locale.ROOT, "%.0f", value)
                : String.valueOf(value);
    }
}
