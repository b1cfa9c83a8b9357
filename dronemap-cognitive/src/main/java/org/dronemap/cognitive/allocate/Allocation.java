package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;

/** The result of a search: each drone's waypoints in order. Those in no tour are unserved. Immutable. */
public final class Allocation {
    private final int[][] orders;
    private final int[] unserved;
    private final double longestSeconds;
    private final double sum;
    private final long iterations;

    Allocation(int[][] orders, int[] unserved, double longestSeconds, double sum, long iterations) {
        this.orders = orders;
        this.unserved = unserved;
        this.longestSeconds = longestSeconds;
        this.sum = sum;
        this.iterations = iterations;
    }

    static Allocation of(AllocationProblem instance, LegCosts costs, List<BaselineTour> rounds) {
        return of(instance, costs, rounds.stream().map(BaselineTour::order).toArray(int[][]::new), 0);
    }

    /** Judges tours anew. */
    static Allocation of(AllocationProblem instance, LegCosts costs, int[][] orders, long iterations) {
        TourLists tours = new TourLists(instance, costs);
        tours.set(orders);
        IndexSet absent = tours.absent();
        int[] unserved = new int[absent.size()];
        for (int i = 0; i < unserved.length; i++) {
            unserved[i] = absent.get(i);
        }
        Arrays.sort(unserved);
        return new Allocation(orders, unserved, tours.longest(), tours.total(), iterations);
    }

    /** The same plan, after so many iterations in all. */
    Allocation after(long others) {
        return new Allocation(orders, unserved, longestSeconds, sum, others);
    }

    /** For each drone the numbers of its waypoints. */
    public int[][] orders() {
        return Arrays.stream(orders).map(int[]::clone).toArray(int[][]::new);
    }

    /** The numbers of the waypoints left out, ascending. */
    public int[] unserved() {
        return unserved.clone();
    }

    /** When the last tour ends, on the plan's clock. */
    public double longestSeconds() {
        return longestSeconds;
    }

    /** What the aim sums, over all tours. */
    public double sum() {
        return sum;
    }

    /** How many changes were tried. */
    public long iterations() {
        return iterations;
    }
}
