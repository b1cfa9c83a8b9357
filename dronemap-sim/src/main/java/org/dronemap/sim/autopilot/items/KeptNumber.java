package org.dronemap.sim.autopilot.items;

import java.util.Map;
import java.util.function.DoubleUnaryOperator;

/**
 * One number of an item as ArduPilot's storage keeps it; {@code mayBeNothing}: a number that is none is taken too.
 */
record KeptNumber(DoubleUnaryOperator kept, boolean mayBeNothing) {
    private static final double TURN_SHARES = 256;
    private static final int HALF_BITS = 10;
    private static final int HALF_LEAST_EXPONENT = -14;
    private static final double HALF_MOST = 65_520;

    private static final Map<String, DoubleUnaryOperator> KINDS = Map.ofEntries(
            Map.entry("-", value -> 0),
            Map.entry("f", value -> value),
            Map.entry("u8", value -> (int) value & 0xFF),
            Map.entry("i8", value -> (byte) (int) value),
            Map.entry("u16", value -> (int) value & 0xFFFF),
            Map.entry("i16", value -> (short) (int) value),
            Map.entry("half", KeptNumber::half),
            Map.entry("flag", value -> value > 0 ? 1 : 0),
            Map.entry("odd", value -> (long) value & 1),
            Map.entry("sign", value -> value < 0 ? -1 : 1),
            Map.entry("cap8", value -> Math.min(255, (int) value & 0xFFFF)),
            Map.entry("cm", value -> ((int) (value * 100) & 0xFFFF) / 100.0),
            Map.entry("turns", KeptNumber::turns),
            Map.entry("radius", KeptNumber::radius),
            Map.entry("seconds", value -> (int) Math.max(0, Math.min(0xFFFF, value))),
            Map.entry("i180", value -> within(value, -180, 180)),
            Map.entry("i90", value -> within(value, -90, 90)),
            Map.entry("i360", value -> within(value, -180, 360)));

    /** {@code word} as the table has it. */
    static KeptNumber of(String word) {
        boolean mayBeNothing = word.endsWith("?");
        String kind = mayBeNothing ? word.substring(0, word.length() - 1) : word;
        DoubleUnaryOperator kept = KINDS.get(kind);
        if (kept == null) {
            throw new IllegalArgumentException(
                    "the table of mission items has no kind of number called '" + word + "'");
        }
        return new KeptNumber(kept, mayBeNothing);
    }

    boolean accepts(float value) {
        return Float.isNaN(value) ? mayBeNothing : !Float.isInfinite(value);
    }

    double keep(double value) {
        return kept.applyAsDouble(Double.isNaN(value) ? 0 : value);
    }

    /** Whole turns up to 255; less than one in 256 parts. */
    private static double turns(double value) {
        boolean inParts = value > 0 && value < 1;
        double stored = inParts ? value * TURN_SHARES : value;
        return stored < 0 ? (int) stored & 0xFF : Math.min(255, (int) stored) / (inParts ? TURN_SHARES : 1);
    }

    /** Metres up to 255, beyond in tens; negative turns to the left. */
    private static double radius(double value) {
        double size = Math.abs(value);
        double stored = size <= 255 ? (int) size : Math.min(255, (int) (size * 0.1)) * 10;
        return value < 0 ? -stored : stored;
    }

    /** A float of 16 bits, rounded to ten of them. */
    private static double half(double value) {
        if (Math.abs(value) >= HALF_MOST) {
            return Math.copySign(Double.POSITIVE_INFINITY, value);
        }
        double unit = Math.scalb(1.0, Math.max(Math.getExponent(value), HALF_LEAST_EXPONENT) - HALF_BITS);
        return Math.rint(value / unit) * unit;
    }

    private static double within(double value, double least, double most) {
        return value >= least && value <= most ? (int) value : 0;
    }
}
