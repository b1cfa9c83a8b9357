package org.dronemap.cognitive.allocate;

import java.util.SplittableRandom;

/**
 * The search's ruin step: removes strings of neighbouring waypoints from nearby tours (Christiaens and Vanden Berghe
 * 2020, section 5.2). Where tours are long several strings may come out of one: those that pass near are often the same
 * one.
 */
final class StringRemoval {
    private static final int LONGEST = 12;
    private static final double MEAN_REMOVED = 12;
    /** Of few waypoints no more than this share on average, else nothing is left to build on. */
    private static final double SHARE_REMOVED = 0.3;

    private static final double SPLIT = 0.5;
    private static final double KEEP_MORE = 0.5;

    private final TourLists tours;
    private final NeighbourLists near;
    private final SplittableRandom random;
    private final boolean longFirst;
    private final int[] ruinedIn;
    private int turn;

    /** {@code longFirst}: long tours are what counts, and are ruined more often than short ones. */
    StringRemoval(TourLists tours, NeighbourLists near, SplittableRandom random, boolean longFirst) {
        this.tours = tours;
        this.near = near;
        this.random = random;
        this.longFirst = longFirst;
        ruinedIn = new int[tours.drones];
    }

    void remove() {
        turn++;
        double mean = meanSize();
        double longest = Math.min(LONGEST, mean);
        double removed = Math.min(MEAN_REMOVED, SHARE_REMOVED * tours.waypoints);
        int strings = (int) (1 + random.nextDouble() * Math.max(0, 4 * removed / (1 + longest) - 1));
        boolean again = mean > 2 * LONGEST;
        int seed = seed();
        for (int rank = -1; rank < near.length() && strings > 0; rank++) {
            int waypoint = rank < 0 ? seed : near.get(seed, rank);
            int r = tours.drone(waypoint);
            if (r != TourLists.NONE && (again || ruinedIn[r] != turn)) {
                ruinedIn[r] = turn;
                strings--;
                removeString(waypoint, r, (int) (1 + random.nextDouble() * Math.min(longest, tours.size(r))));
            }
        }
    }

    /** Any waypoint, or of two the one in the longer tour: a drone with time to spare is no part of the difficulty. */
    private int seed() {
        int one = random.nextInt(tours.waypoints);
        if (!longFirst) {
            return one;
        }
        int other = random.nextInt(tours.waypoints);
        int r = tours.drone(one);
        int s = tours.drone(other);
        boolean both = r != TourLists.NONE && s != TourLists.NONE;
        return both && tours.seconds(s) > tours.seconds(r) ? other : one;
    }

    private double meanSize() {
        int flying = 0;
        for (int r = 0; r < tours.drones; r++) {
            flying += tours.size(r) > 0 ? 1 : 0;
        }
        return (double) (tours.waypoints - tours.absent().size()) / Math.max(1, flying);
    }

    private void removeString(int waypoint, int r, int length) {
        int kept = 0;
        if (length > 1 && random.nextDouble() < SPLIT) {
            kept = 1;
            while (length + kept < tours.size(r) && random.nextDouble() < KEEP_MORE) {
                kept++;
            }
            kept = Math.min(kept, tours.size(r) - length);
        }
        removeString(waypoint, length + kept, kept, kept == 0 ? 0 : 1 + random.nextInt(length - 1));
    }

    /** Removes a string that contains the waypoint, but for some that are kept in its middle. */
    private void removeString(int waypoint, int length, int kept, int keptFrom) {
        int place = waypoint;
        for (int back = random.nextInt(length); back > 0 && tours.isWaypoint(tours.prev(place)); back--) {
            place = tours.prev(place);
        }
        for (int i = 0; i < length && tours.isWaypoint(place); i++) {
            int after = tours.next(place);
            if (i < keptFrom || i >= keptFrom + kept) {
                tours.remove(place);
            }
            place = after;
        }
    }
}
