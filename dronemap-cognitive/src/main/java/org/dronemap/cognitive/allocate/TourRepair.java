package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * Removes from existing tours the waypoints that they cannot serve any more: as few as need be, the least important
 * first.
 */
final class TourRepair {
    private final AllocationProblem instance;
    private final LegCosts costs;

    TourRepair(AllocationProblem instance, LegCosts costs) {
        this.instance = instance;
        this.costs = costs;
    }

    int[][] flyable(int[][] orders) {
        int[][] kept = new int[orders.length][];
        Arrays.setAll(kept, r -> flyable(r, orders[r]));
        return kept;
    }

    private int[] flyable(int r, int[] order) {
        List<Integer> kept = connected(r, order);
        double excess = excess(r, kept, -1);
        while (excess > 0 && !kept.isEmpty()) {
            int worst = worst(r, kept, excess);
            excess = excess(r, kept, worst);
            kept.remove(worst);
        }
        return kept.stream().mapToInt(Integer::intValue).toArray();
    }

    /** Those that it may serve and that a way leads to from the one before. */
    private List<Integer> connected(int r, int[] order) {
        List<Integer> kept = new ArrayList<>(order.length);
        int at = instance.start(r);
        for (int waypoint : order) {
            if (costs.allows(waypoint, r) && Double.isFinite(costs.seconds(r, at, waypoint))) {
                kept.add(waypoint);
                at = waypoint;
            }
        }
        while (!kept.isEmpty() && !Double.isFinite(costs.seconds(r, kept.get(kept.size() - 1), instance.end(r)))) {
            kept.remove(kept.size() - 1);
        }
        return kept;
    }

    /** Where in the tour the one is that makes it least impossible for what it is worth. */
    private int worst(int r, List<Integer> kept, double excess) {
        int worst = kept.size() - 1;
        double most = 0;
        for (int at = 0; at < kept.size(); at++) {
            double less = excess - excess(r, kept, at);
            double gain = less / instance.visits().get(kept.get(at)).priority();
            if (gain > most) {
                most = gain;
                worst = at;
            }
        }
        return worst;
    }

    /** By which share the tour is too late, and too far, with one waypoint left out. */
    private double excess(int r, List<Integer> kept, int without) {
        TourEvaluation flight = new TourEvaluation(costs, r);
        int at = instance.start(r);
        for (int i = 0; i < kept.size(); i++) {
            if (i != without) {
                flight.fly(at, kept.get(i));
                at = kept.get(i);
            }
        }
        flight.fly(at, instance.end(r));
        double late = flight.late() ? flight.lateSeconds() / Math.max(1, flight.seconds()) : 0;
        double range = costs.rangeJoules(r);
        double drawn = InsertionFeasibility.withinRange(costs, r, flight.joules())
                ? 0
                : (flight.joules() - range) / Math.max(1, range);
        return late + drawn;
    }
}
