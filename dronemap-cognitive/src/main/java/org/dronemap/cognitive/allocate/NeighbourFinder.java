package org.dronemap.cognitive.allocate;

import java.util.Arrays;

/** Finds the neighbours of one waypoint: the nearest of all, and the nearest in each compass quarter. */
final class NeighbourFinder {
    private static final int QUARTERS = 4;
    private static final int OF_EACH = 2;
    /** To the east, and to the west; an empty quarter would else be looked for to the end of the world. */
    private static final int MOST_LOOKED_AT = 2_000;

    private final double[] east;
    private final double[] north;
    private final int center;
    private final NearestItems all;
    private final NearestItems[] quarters = new NearestItems[QUARTERS];

    NeighbourFinder(double[] east, double[] north, int center, int most) {
        this.east = east;
        this.north = north;
        this.center = center;
        all = new NearestItems(most);
        Arrays.setAll(quarters, quarter -> new NearestItems(OF_EACH));
    }

    /** The waypoints in order from west to east, and where among them the one in the middle is. */
    int[] look(int[] eastward, int at) {
        for (int step = 1; step <= MOST_LOOKED_AT; step++) {
            boolean eastGoesOn = collect(eastward, at + step);
            boolean westGoesOn = collect(eastward, at - step);
            if (!eastGoesOn && !westGoesOn) {
                break;
            }
        }
        return merged();
    }

    /** False when nothing from there on can be near enough. */
    private boolean collect(int[] eastward, int index) {
        if (index < 0 || index >= eastward.length) {
            return false;
        }
        int other = eastward[index];
        double dx = east[other] - east[center];
        double dy = north[other] - north[center];
        double squared = dx * dx + dy * dy;
        all.offer(other, squared);
        quarters[(dx < 0 ? 0 : 1) + (dy < 0 ? 0 : 2)].offer(other, squared);
        return dx * dx < reach();
    }

    private double reach() {
        double reach = all.farthest();
        for (NearestItems quarter : quarters) {
            reach = Math.max(reach, quarter.farthest());
        }
        return reach;
    }

    /** The likely ones, then the rest. */
    private int[] merged() {
        NearestItems close = new NearestItems(Math.min(NeighbourLists.CLOSE, all.count()));
        for (NearestItems quarter : quarters) {
            quarter.forEach(close::offer);
        }
        all.forEach((waypoint, squared) -> {
            if (!close.has(waypoint) && !close.isFull()) {
                close.offer(waypoint, squared);
            }
        });
        int[] merged = new int[all.count()];
        int count = 0;
        for (int rank = 0; rank < close.count(); rank++) {
            merged[count++] = close.get(rank);
        }
        for (int rank = 0; rank < all.count() && count < merged.length; rank++) {
            if (!close.has(all.get(rank))) {
                merged[count++] = all.get(rank);
            }
        }
        return merged;
    }
}
