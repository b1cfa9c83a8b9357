package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * The position of a drone at the beginning of the plan, and when it can depart.
 *
 * @param place the ground under it, or where it flies
 * @param readySeconds when it can set off, on the plan's clock; till then it stays there
 */
@Stored(names = "place airborne readySeconds")
public record Start(Place place, boolean airborne, double readySeconds) {
    public Start {
        Require.within("readySeconds", readySeconds, 0, Double.MAX_VALUE);
    }

    public static Start onGround(Place place) {
        return new Start(place, false, 0);
    }

    public static Start inFlight(Place place) {
        return new Start(place, true, 0);
    }
}
