package org.dronemap.cognitive.allocate;

import java.util.SplittableRandom;

/**
 * The search's recreate step: inserts removed waypoints where they cost least, now and then overlooking a place
 * (Christiaens and Vanden Berghe, Slack Induction by String Removals, Transportation Science 54(2), 2020, section 5.3).
 */
final class GreedyInsertion {
    /** Where there are more drones than this, ends of a few tours by chance are looked at, not of all. */
    private static final int MOST_ENDS = 12;

    private static final int OVERLOOKED_IN_1024 = 10;
    /** More that cannot be served are not all tried again each time. */
    private static final int MOST_TRIED = 64;

    private final TourLists tours;
    private final LegCosts costs;
    private final InsertionChoice choice;
    private final NeighbourLists near;
    private final SplittableRandom random;
    private final int breadth;
    private final int[] order;
    private final double[] keys;

    GreedyInsertion(TourLists tours, SearchCost worth, LegCosts costs, NeighbourLists near, SplittableRandom random) {
        this.tours = tours;
        this.costs = costs;
        this.near = near;
        this.random = random;
        choice = new InsertionChoice(tours, worth, costs);
        breadth = Math.min(NeighbourLists.CLOSE, near.length());
        order = new int[tours.waypoints];
        keys = new double[tours.waypoints];
    }

    /** All that are absent, in random order: how a search begins. */
    void insertAll() {
        insert(tours.waypoints);
    }

    void insertAbsent() {
        insert(MOST_TRIED);
    }

    private void insert(int most) {
        IndexSet absent = tours.absent();
        int count = Math.min(absent.size(), most);
        for (int i = 0; i < count; i++) {
            order[i] = absent.size() <= most ? absent.get(i) : absent.get(random.nextInt(absent.size()));
        }
        if (count <= MOST_TRIED) {
            sort(count);
        } else {
            shuffle(count);
        }
        for (int i = 0; i < count; i++) {
            if (tours.drone(order[i]) == TourLists.NONE) {
                insertOne(order[i]);
            }
        }
    }

    private void shuffle(int count) {
        for (int i = count - 1; i > 0; i--) {
            int other = random.nextInt(i + 1);
            int waypoint = order[i];
            order[i] = order[other];
            order[other] = waypoint;
        }
    }

    /** By chance, farthest from the first drone's start first, or nearest first: 4, 2, 1 times of 7. */
    private void sort(int count) {
        int rule = random.nextInt(7);
        int base = tours.start(0);
        for (int i = 0; i < count; i++) {
            double distance = rule < 4 ? random.nextDouble() : costs.seconds(0, base, order[i]);
            insertSorted(i, order[i], rule == 4 || rule == 5 ? -distance : distance);
        }
    }

    private void insertSorted(int sorted, int waypoint, double key) {
        int at = sorted;
        while (at > 0 && keys[at - 1] > key) {
            keys[at] = keys[at - 1];
            order[at] = order[at - 1];
            at--;
        }
        keys[at] = key;
        order[at] = waypoint;
    }

    private void insertOne(int waypoint) {
        choice.clear();
        for (int rank = 0; rank < breadth; rank++) {
            int other = near.get(waypoint, rank);
            int r = tours.drone(other);
            if (r != TourLists.NONE && costs.allows(waypoint, r) && !overlooked()) {
                choice.beside(waypoint, r, other);
            }
        }
        boolean few = tours.drones <= MOST_ENDS;
        for (int i = few ? tours.drones : MOST_ENDS; i > 0; i--) {
            int r = few ? i - 1 : random.nextInt(tours.drones);
            if (costs.allows(waypoint, r)) {
                choice.atAnEnd(waypoint, r);
            }
        }
        if (choice.after() != TourLists.NONE) {
            tours.insert(waypoint, choice.after());
        }
    }

    private boolean overlooked() {
        return (random.nextInt() & 1023) < OVERLOOKED_IN_1024;
    }
}
