package org.dronemap.cognitive.allocate;

import java.util.BitSet;
import org.dronemap.cognitive.cost.AllocationProblem;

/** Inserts a few waypoints that no drone has into a good plan where they cost least, the most important first. */
final class OrphanInsertion {
    /** In larger plans only places beside near neighbours are looked at, and the ends of tours, as long as there are some. */
    private static final int MOST_WAYPOINTS = 500;

    private final TourLists tours;
    private final SearchCost worth;
    private final LegCosts costs;
    private final AllocationProblem instance;
    private final NeighbourLists near;
    private final InsertionChoice choice;
    private final double[] changes;
    private final int[] afters;

    OrphanInsertion(
            TourLists tours, SearchCost worth, LegCosts costs, AllocationProblem instance, NeighbourLists near) {
        this.tours = tours;
        this.worth = worth;
        this.costs = costs;
        this.instance = instance;
        this.near = near;
        choice = new InsertionChoice(tours, worth, costs);
        changes = new double[tours.waypoints];
        afters = new int[tours.waypoints];
    }

    void insertAll(BitSet closed) {
        worth.rescale();
        worth.current();
        for (int i = 0; i < tours.absent().size(); i++) {
            lookEverywhere(tours.absent().get(i), closed);
        }
        for (int next = next(); next != TourLists.NONE; next = next()) {
            int r = tours.drone(afters[next]);
            tours.insert(next, afters[next]);
            worth.rescale();
            worth.current();
            lookAgain(r, closed);
        }
    }

    /** The one to be put in next, or {@link TourLists#NONE} when there is no place for any. */
    private int next() {
        int best = TourLists.NONE;
        for (int i = 0; i < tours.absent().size(); i++) {
            int orphan = tours.absent().get(i);
            if (afters[orphan] != TourLists.NONE && (best == TourLists.NONE || isBefore(orphan, best))) {
                best = orphan;
            }
        }
        return best;
    }

    private boolean isBefore(int one, int other) {
        int byPriority = Double.compare(
                instance.visits().get(other).priority(),
                instance.visits().get(one).priority());
        int order = byPriority != 0 ? byPriority : Double.compare(changes[one], changes[other]);
        return order != 0 ? order < 0 : one < other;
    }

    private void lookEverywhere(int orphan, BitSet closed) {
        choice.clear();
        if (tours.waypoints > MOST_WAYPOINTS) {
            lookNearby(orphan, closed);
        }
        boolean found = choice.after() != TourLists.NONE;
        for (int r = 0; r < tours.drones && !found; r++) {
            if (isOpen(orphan, r, closed)) {
                choice.everywhere(orphan, r);
            }
        }
        recordBest(orphan);
    }

    /** One tour has changed: those that were best in it may be best elsewhere now. */
    private void lookAgain(int changed, BitSet closed) {
        for (int i = 0; i < tours.absent().size(); i++) {
            int orphan = tours.absent().get(i);
            if (afters[orphan] == TourLists.NONE) {
                continue;
            }
            if (tours.drone(afters[orphan]) == changed) {
                lookEverywhere(orphan, closed);
            } else {
                lookBeside(orphan, changed);
            }
        }
    }

    private void lookBeside(int orphan, int changed) {
        choice.clear();
        if (costs.allows(orphan, changed)) {
            choice.everywhere(orphan, changed);
        }
        if (choice.change() < changes[orphan]) {
            recordBest(orphan);
        }
    }

    private void recordBest(int orphan) {
        changes[orphan] = choice.change();
        afters[orphan] = choice.after();
    }

    private void lookNearby(int orphan, BitSet closed) {
        for (int rank = 0; rank < near.length(); rank++) {
            int other = near.get(orphan, rank);
            int r = tours.drone(other);
            if (r != TourLists.NONE && isOpen(orphan, r, closed)) {
                choice.beside(orphan, r, other);
            }
        }
        for (int r = 0; r < tours.drones; r++) {
            if (isOpen(orphan, r, closed)) {
                choice.atAnEnd(orphan, r);
            }
        }
    }

    private boolean isOpen(int orphan, int r, BitSet closed) {
        return !closed.get(r) && costs.allows(orphan, r);
    }
}
