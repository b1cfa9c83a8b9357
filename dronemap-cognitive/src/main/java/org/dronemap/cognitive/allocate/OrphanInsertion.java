package org.dronemap.cognitive.allocate;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.dronemap.cognitive.cost.Instance;

/**
 * Puts what is absent where it costs least of all places, the most important first, then the cheapest: for a few orphans
 * of a plan that is good otherwise.
 */
final class OrphanInsertion {
    /** So many places are looked at; with more orphans only those beside near neighbours are. */
    private static final double MOST_LOOKS = 5e6;

    private final Tours tours;
    private final Worth worth;
    private final Costs costs;
    private final Instance instance;
    private final Neighbours near;
    private final Choice choice;
    private final double[] changes;
    private final int[] afters;

    OrphanInsertion(Tours tours, Worth worth, Costs costs, Instance instance, Neighbours near) {
        this.tours = tours;
        this.worth = worth;
        this.costs = costs;
        this.instance = instance;
        this.near = near;
        choice = new Choice(tours, worth, costs);
        changes = new double[tours.waypoints];
        afters = new int[tours.waypoints];
    }

    void insertAll(BitSet closed) {
        worth.rescale();
        worth.now();
        if (closed.isEmpty() && looks() > MOST_LOOKS) {
            new GreedyInsertion(tours, worth, costs, near, new SplittableRandom(0)).insertAll();
            return;
        }
        for (int i = 0; i < tours.absent().size(); i++) {
            lookEverywhere(tours.absent().get(i), closed);
        }
        for (int next = next(); next != Tours.NONE; next = next()) {
            int r = tours.drone(afters[next]);
            tours.insert(next, afters[next]);
            worth.rescale();
            worth.now();
            lookAgain(r, closed);
        }
    }

    private double looks() {
        double mean = (double) tours.waypoints / tours.drones;
        double once = (double) tours.absent().size() * tours.waypoints;
        return costs.timed() ? once * mean : once;
    }

    /** The one to be put in next, or {@link Tours#NONE} when there is no place for any. */
    private int next() {
        int best = Tours.NONE;
        for (int i = 0; i < tours.absent().size(); i++) {
            int orphan = tours.absent().get(i);
            if (afters[orphan] != Tours.NONE && (best == Tours.NONE || isBefore(orphan, best))) {
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
        for (int r = 0; r < tours.drones; r++) {
            if (!closed.get(r)) {
                look(orphan, r);
            }
        }
        note(orphan);
    }

    /** One tour has changed: those that were best in it may be best elsewhere now. */
    private void lookAgain(int changed, BitSet closed) {
        for (int i = 0; i < tours.absent().size(); i++) {
            int orphan = tours.absent().get(i);
            if (afters[orphan] == Tours.NONE) {
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
        look(orphan, changed);
        if (choice.change() < changes[orphan]) {
            note(orphan);
        }
    }

    private void note(int orphan) {
        changes[orphan] = choice.change();
        afters[orphan] = choice.after();
    }

    private void look(int orphan, int r) {
        if (!costs.allows(orphan, r)) {
            return;
        }
        int end = tours.end(r);
        for (int place = tours.start(r); place != end; place = tours.next(place)) {
            double more =
                    costs.seconds(r, place, orphan) + costs.seconds(r, orphan, tours.next(place)) - tours.out(place);
            choice.judge(orphan, r, place, more);
        }
    }
}
