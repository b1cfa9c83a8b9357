package org.dronemap.core.zone;

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
}
