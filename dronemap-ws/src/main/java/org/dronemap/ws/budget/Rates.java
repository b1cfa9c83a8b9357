package org.dronemap.ws.budget;

import java.util.Map;

/** Long-term rate of each kind of work for one user, per second; a kind without a rate is unbounded. */
public record Rates(Map<Work, Double> perSecond) {
    /** Generous for people and for programs that fly fleets; a program that has gone mad is noticed within a second. */
    public static final Rates DEFAULT =
            new Rates(Map.of(Work.REQUEST, 200.0, Work.COMMAND, 50.0, Work.EXPORT, 5.0, Work.SIGN_IN, 5.0));

    public static final Rates UNBOUNDED = new Rates(Map.of());

    public Rates {
        perSecond = Map.copyOf(perSecond);
    }
}
