package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/** The energy left in a battery and the reserve to keep at the end, in J; infinite without a limit. */
@Stored(names = "remainingJoules reserveJoules")
public record EnergyBudget(double remainingJoules, double reserveJoules) {
    public static final EnergyBudget UNLIMITED = new EnergyBudget(Double.POSITIVE_INFINITY, 0);

    private static final double JOULES_PER_WATT_HOUR = 3_600;

    public EnergyBudget {
        Require.notNegative("remainingJoules", remainingJoules);
        Require.within("reserveJoules", reserveJoules, 0, Double.MAX_VALUE);
    }

    public static EnergyBudget ofWattHours(double remaining, double reserve) {
        return new EnergyBudget(remaining * JOULES_PER_WATT_HOUR, reserve * JOULES_PER_WATT_HOUR);
    }

    /** What may be drawn. */
    public double rangeJoules() {
        return Math.max(0, remainingJoules - reserveJoules);
    }
}
