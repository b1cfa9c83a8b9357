package org.dronemap.cognitive.cost;

/**
 * The objective as the search sees it: weighted sum of the longest tour's duration and of a measure over all tours.
 *
 * @param longestWeight weight of the duration of the longest tour, in seconds
 * @param measure what is summed
 * @param sumWeight weight of the sum, in the measure's unit
 * @param everyDrone whether each drone must fly, else drones may be left on the ground
 */
public record AllocationObjective(double longestWeight, Measure measure, double sumWeight, boolean everyDrone) {
    /** The quantity that is summed over all tours. */
    public enum Measure {
        SECONDS,
        METERS,
        JOULES
    }

    /** The longest tour as short as can be; among equals the smaller sum. */
    public static AllocationObjective minMax() {
        return new AllocationObjective(1, Measure.SECONDS, 0, false);
    }

    public static AllocationObjective minSum(Measure measure) {
        return new AllocationObjective(0, measure, 1, false);
    }

    public AllocationObjective withEveryDrone() {
        return new AllocationObjective(longestWeight, measure, sumWeight, true);
    }
}
