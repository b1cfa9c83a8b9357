package org.dronemap.ws.budget;

import java.util.Map;

/** Long-term rate of each kind of work for one user, per second; a kind without a rate is unbounded. */
public record BudgetRates(Map<WorkKind, Double> perSecond) {
    /** Generous for people and for programs that fly fleets; a program that has gone mad is noticed within a second. */
    public static final BudgetRates DEFAULT = new BudgetRates(
            Map.of(WorkKind.REQUEST, 200.0, WorkKind.COMMAND, 50.0, WorkKind.EXPORT, 5.0, WorkKind.SIGN_IN, 5.0));

    public static final BudgetRates UNBOUNDED = new BudgetRates(Map.of());

    public BudgetRates {
        perSecond = Map.copyOf(perSecond);
    }
}
