package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;

/** Baseline allocation: the drone whose tour is shortest so far flies on to the nearest waypoint left. */
public final class NearestNeighbourBaseline implements Baseline {
    private static final int NONE = -1;

    @Override
    public Allocation allocate(AllocationProblem instance) {
        LegCosts costs = new LegCosts(instance);
        List<BaselineTour> rounds = BaselineTour.all(instance, costs);
        List<BaselineTour> flying = new ArrayList<>(rounds);
        BitSet left = new BitSet();
        left.set(0, instance.visits().size());
        while (!left.isEmpty() && !flying.isEmpty()) {
            BaselineTour shortest = flying.stream()
                    .min(Comparator.comparingDouble(BaselineTour::seconds))
                    .orElseThrow();
            int next = next(shortest, left);
            if (next == NONE) {
                flying.remove(shortest);
            } else {
                left.clear(next);
            }
        }
        return Allocation.of(instance, costs, rounds);
    }

    /** Flies on to the nearest one that the drone can serve; those that it cannot are looked at once more in its next turn. */
    private static int next(BaselineTour round, BitSet left) {
        BitSet candidates = (BitSet) left.clone();
        while (!candidates.isEmpty()) {
            int nearest = NONE;
            double least = Double.POSITIVE_INFINITY;
            for (int waypoint = candidates.nextSetBit(0);
                    waypoint >= 0;
                    waypoint = candidates.nextSetBit(waypoint + 1)) {
                double seconds = round.secondsOnTo(waypoint);
                if (nearest == NONE || seconds < least) {
                    least = seconds;
                    nearest = waypoint;
                }
            }
            if (round.append(nearest)) {
                return nearest;
            }
            candidates.clear(nearest);
        }
        return NONE;
    }
}
