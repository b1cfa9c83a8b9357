package org.dronemap.cognitive.problem;

import org.dronemap.core.separation.Separation;
import org.dronemap.core.stored.Stored;

/**
 * Rules for every plan: separation, least link quality, room beside barriers and take-off height.
 *
 * @param leastLinkQuality drones whose link is worse are given nothing, 0 to 1
 * @param roomMeters what ways round barriers leave beside them
 * @param takeOffMeters a take-off leads at least so high, and a drone comes to its landing no lower
 */
@Stored(names = "separation leastLinkQuality roomMeters takeOffMeters")
public record PlanningRules(Separation separation, double leastLinkQuality, double roomMeters, double takeOffMeters) {
    public static final PlanningRules USUAL = new PlanningRules(Separation.USUAL, 0.5, 3, 5);

    public PlanningRules {
        Require.within("leastLinkQuality", leastLinkQuality, 0, 1);
        Require.within("roomMeters", roomMeters, 1, 1_000);
        Require.within("takeOffMeters", takeOffMeters, 1, 500);
    }
}
