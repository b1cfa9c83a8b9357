package org.dronemap.cognitive.allocate;

import java.util.Arrays;

/** What a search found: for each drone its waypoints in order. Those in no tour are unserved. Immutable. */
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
