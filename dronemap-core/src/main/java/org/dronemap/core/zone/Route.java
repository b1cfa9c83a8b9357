package org.dronemap.core.zone;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Route that a command may send a drone along.
 *
 * @param doubt why a part of it cannot be said, as a sentence; null when all of it is known
 */
public record Route(List<Leg> legs, @Nullable String doubt) {
    /** Of what moves nothing. */
    public static final Route NONE = new Route(List.of(), null);

    public Route {
        legs = List.copyOf(legs);
    }
}
