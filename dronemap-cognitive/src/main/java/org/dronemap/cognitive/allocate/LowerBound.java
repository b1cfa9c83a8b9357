package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * A lower bound on the cost of any plan that serves every waypoint (Held and Karp's 1-tree bound). All starts and ends
 * are seen as one base: then the tours hold a 1-tree over waypoints and base, and what a tree costs at least is pushed
 * up by multipliers on the waypoints, each of which has two legs (Held and Karp, The Traveling-Salesman Problem and
 * Minimum Spanning Trees, 1970-71). The longest tour is no shorter than the mean, nor than the way out to any waypoint
 * and back.
 */
public final class LowerBound {
    /** Beyond this many waypoints only the way out and back is looked at: a tree costs their square each time. */
    private static final int MOST_WAYPOINTS = 4_000;

    private final AllocationProblem instance;
    private final LegCosts costs;
    private final int waypoints;
    private final int drones;
    private final double[] multipliers;
    private final int[] degrees;
    private final double[] reach;
    private final int[] parent;

    private LowerBound(AllocationProblem instance) {
        this.instance = instance;
        costs = new LegCosts(instance);
        waypoints = instance.visits().size();
        drones = instance.carriers().size();
        multipliers = new double[waypoints + 1];
        degrees = new int[waypoints + 1];
        reach = new double[waypoints + 1];
        parent = new int[waypoints + 1];
    }

    /** In the unit of the aim, 0 where some waypoint cannot be reached; {@code rounds} of pushing up cost the square of the waypoints each. */
    public static double of(AllocationProblem instance, int rounds) {
        LowerBound bound = new LowerBound(instance);
        AllocationObjective aim = instance.aim();
        double sum = 0;
        if (bound.waypoints > 1 && bound.waypoints <= MOST_WAYPOINTS) {
            sum = bound.sum(rounds);
        }
        double longest = bound.farthest();
        if (aim.measure() == AllocationObjective.Measure.SECONDS) {
            longest = Math.max(longest, sum / bound.drones);
        }
        double least = aim.longestWeight() * longest + aim.sumWeight() * sum;
        return Double.isFinite(least) ? least : 0;
    }

    private double farthest() {
        double farthest = 0;
        for (int waypoint = 0; waypoint < waypoints; waypoint++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int r = 0; r < drones; r++) {
                if (costs.allows(waypoint, r)) {
                    TourEvaluation flight = new TourEvaluation(costs, r);
                    flight.fly(instance.start(r), waypoint);
                    flight.fly(waypoint, instance.end(r));
                    nearest = Math.min(nearest, flight.seconds());
                }
            }
            farthest = Math.max(farthest, Double.isFinite(nearest) ? nearest : 0);
        }
        return farthest;
    }

    /** Bound on the sum of all tours. */
    private double sum(int rounds) {
        double best = Math.max(0, tree());
        double step = best / waypoints / 10;
        for (int round = 0; round < rounds && step > 0; round++) {
            for (int i = 0; i < waypoints; i++) {
                multipliers[i] += step * (degrees[i] - 2);
            }
            best = Math.max(best, tree());
            step *= 0.97;
        }
        return best;
    }

    /** The 1-tree that costs least with the multipliers as they are; waypoint 0 is the one outside of the tree. */
    private double tree() {
        int base = waypoints;
        Arrays.fill(degrees, 0);
        Arrays.fill(reach, Double.POSITIVE_INFINITY);
        boolean[] in = new boolean[waypoints + 1];
        double total = 0;
        int last = base;
        in[base] = true;
        for (int count = 1; count < waypoints; count++) {
            last = grow(in, last);
            in[last] = true;
            total += reach[last];
            degrees[last]++;
            degrees[parent[last]]++;
        }
        total += twoCheapestOfTheFirst();
        total += (drones - 1) * Math.min(0, cheapestFromBase());
        for (int i = 0; i < waypoints; i++) {
            total -= 2 * multipliers[i];
            total += costs.sumsSeconds() ? costs.serviceSeconds(i) : 0;
        }
        return total;
    }

    private int grow(boolean[] in, int last) {
        int nearest = -1;
        for (int i = 1; i < waypoints; i++) {
            if (in[i]) {
                continue;
            }
            double cost = edge(last, i);
            if (cost < reach[i]) {
                reach[i] = cost;
                parent[i] = last;
            }
            if (nearest < 0 || reach[i] < reach[nearest]) {
                nearest = i;
            }
        }
        return nearest;
    }

    /** A drone may fly out to it and straight back: the base counts twice. */
    private double twoCheapestOfTheFirst() {
        double first = edge(0, waypoints);
        double second = first;
        int firstAt = waypoints;
        int secondAt = waypoints;
        for (int i = 1; i < waypoints; i++) {
            double cost = edge(0, i);
            if (cost < first) {
                second = first;
                secondAt = firstAt;
                first = cost;
                firstAt = i;
            } else if (cost < second) {
                second = cost;
                secondAt = i;
            }
        }
        degrees[0] += 2;
        degrees[firstAt]++;
        degrees[secondAt]++;
        return first + second;
    }

    /** Each tour but one may leave out one of its legs at the base. */
    private double cheapestFromBase() {
        double cheapest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < waypoints; i++) {
            cheapest = Math.min(cheapest, edge(i, waypoints));
        }
        return cheapest;
    }

    private double edge(int one, int other) {
        return between(Math.min(one, other), Math.max(one, other)) + multipliers[one] + multipliers[other];
    }

    /** The cheaper direction, by the drone for which it is cheapest. */
    private double between(int one, int other) {
        double least = Double.POSITIVE_INFINITY;
        for (int r = 0; r < drones; r++) {
            boolean base = other == waypoints;
            int from = base ? instance.start(r) : other;
            int to = base ? instance.end(r) : other;
            least = Math.min(least, Math.min(leg(r, from, one), leg(r, one, to)));
            if (costs.alike() && !base) {
                break;
            }
        }
        return least;
    }

    /** Flying only. */
    private double leg(int r, int from, int to) {
        return costs.travel(r, from, to);
    }
}
