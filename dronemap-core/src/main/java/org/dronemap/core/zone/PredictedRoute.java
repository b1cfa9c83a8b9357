package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The legs that a drone will fly if it is given a command, as far as they can be predicted; checked against zones.
 *
 * @param doubt why a part of it cannot be said, as a sentence; null when all of it is known
 */
public record PredictedRoute(List<Leg> legs, @Nullable String doubt) {
    /** Of what moves nothing. */
    public static final PredictedRoute NONE = new PredictedRoute(List.of(), null);

    public PredictedRoute {
        legs = List.copyOf(legs);
    }

    /** Where it is not known which of two ways it goes: what is on either. */
    PredictedRoute or(PredictedRoute other) {
        List<Leg> both = new ArrayList<>(legs);
        both.addAll(other.legs());
        return new PredictedRoute(both, doubt == null ? other.doubt() : doubt);
    }
}
