package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * The objective of a plan: weighted sum of the longest tour's duration and of a measure over all tours.
 *
 * @param everyDrone whether each drone must fly, else drones may be left where they are
 */
@Stored(names = "longestWeight measure sumWeight everyDrone")
public record Objective(double longestWeight, Measure measure, double sumWeight, boolean everyDrone) {
    /** The quantity that is summed. */
    @Stored(names = "SECONDS METERS JOULES")
    public enum Measure {
        SECONDS,
        METERS,
        JOULES
    }

    private static final double MOST = 1_000_000;

    public Objective {
        Require.within("longestWeight", longestWeight, 0, MOST);
        Require.within("sumWeight", sumWeight, 0, MOST);
        if (longestWeight == 0 && sumWeight == 0) {
            throw new IllegalArgumentException("longestWeight and sumWeight must not both be 0");
        }
    }

    /** The same where drones may be left where they are. */
    public Objective withIdleDronesAllowed() {
        return new Objective(longestWeight, measure, sumWeight, false);
    }

    /** All done as early as can be. */
    public static Objective earliestEnd() {
        return new Objective(1, Measure.SECONDS, 0, false);
    }

    public static Objective least(Measure measure) {
        return new Objective(0, measure, 1, false);
    }
}
