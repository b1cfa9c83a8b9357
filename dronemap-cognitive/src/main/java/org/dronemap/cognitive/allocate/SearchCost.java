package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import org.dronemap.cognitive.cost.AllocationObjective;

/**
 * The cost that the search minimises: a high norm of all tours' durations, and the weighted sum. In place of the
 * longest tour it looks at a high norm of all, which also tells two plans apart whose longest tours are equal, and at a
 * little of the sum even where nobody asked for it.
 */
final class SearchCost {
    /** The norm; powers of it are six multiplications. */
    private static final int NORM = 64;
    /** How much a sum that nobody asked for weighs, shared by the drones. */
    private static final double TIDINESS = 0.15;

    /** Of two plans with equally long longest tours the one with the smaller sum is better. */
    private static final double BETWEEN_EQUALS = 1e-9;

    private final TourLists tours;
    private final LegCosts costs;
    private final AllocationObjective aim;
    private final double sumWeight;
    private final OmissionPenalties stakes;
    private final double idlePenalty;
    private final double[] known;
    private final double[] powers;
    private final double[] slopes;
    private double reference = 1;
    private double inverse = 1;
    private double slope;

    SearchCost(TourLists tours, LegCosts costs, AllocationObjective aim, OmissionPenalties stakes) {
        this.tours = tours;
        this.costs = costs;
        this.aim = aim;
        sumWeight = sumWeight(aim, tours.drones);
        this.stakes = stakes;
        idlePenalty = aim.everyDrone() ? stakes.most() : 0;
        known = new double[tours.drones];
        powers = new double[tours.drones];
        slopes = new double[tours.drones];
        rescale();
    }

    /** Measures norms relative to the longest tour of now, so that no power overflows. */
    final void rescale() {
        double longest = tours.longest();
        reference = longest > 0 ? longest : 1;
        inverse = 1 / reference;
        Arrays.fill(known, Double.NaN);
    }

    private boolean isIdle(int r) {
        return tours.size(r) == 0 && !costs.busy(r);
    }

    private double power(int r) {
        double seconds = tours.flies(r) ? tours.seconds(r) : 0;
        if (known[r] != seconds) {
            known[r] = seconds;
            powers[r] = raised(seconds * inverse);
            slopes[r] = seconds > 0 ? NORM * powers[r] / seconds : 0;
        }
        return powers[r];
    }

    private static double raised(double x) {
        double power = x * x;
        power *= power;
        power *= power;
        power *= power;
        power *= power;
        return power * power;
    }

    /** The worth of the tours as they are. */
    double current() {
        double norm = 0;
        double sum = 0;
        for (int r = 0; r < tours.drones; r++) {
            norm += power(r);
            sum += sumWeight * tours.flown(r) + (isIdle(r) ? idlePenalty : 0);
        }
        for (int i = 0; i < tours.absent().size(); i++) {
            sum += stakes.leftOut(tours.absent().get(i));
        }
        double root = reference * Math.pow(norm, 1.0 / NORM);
        slope = norm > 0 ? aim.longestWeight() * root / norm / NORM : 0;
        return aim.longestWeight() * root + sum;
    }

    /**
     * By how much the worth would change about, judged by the tours when {@link #current()} was last asked; infinite when that
     * is surely no less than a limit.
     */
    double insertion(int r, double moreSeconds, double moreSum, double limit) {
        double straight = tours.sum(r) - tours.flown(r);
        double change = sumWeight * (moreSum + straight) - (isIdle(r) ? idlePenalty : 0);
        if (slope > 0) {
            double power = power(r);
            // The norm is convex: it lies above its tangent.
            if (change + slope * slopes[r] * moreSeconds >= limit) {
                return Double.POSITIVE_INFINITY;
            }
            change += slope * (raised((tours.seconds(r) + moreSeconds) * inverse) - power);
        }
        return change;
    }

    /** How much what the aim sums weighs. */
    static double sumWeight(AllocationObjective aim, int drones) {
        return Math.max(aim.sumWeight(), TIDINESS * aim.longestWeight() / drones);
    }

    /** What a change of the sum alone comes to, whatever it does to the longest tour. */
    double ofSum(double moreSum) {
        return sumWeight * moreSum;
    }

    double leftOut(int waypoint) {
        return stakes.leftOut(waypoint);
    }

    /** Totals of a plan: the longest tour in seconds, the objective's sum, and the number of idle drones. */
    record Totals(double longest, double total, int idle) {
        Totals with(double seconds, double sum) {
            return new Totals(Math.max(longest, seconds), total + sum, idle);
        }

        Totals withIdle() {
            return new Totals(longest, total, idle + 1);
        }
    }

    /** The aim itself, then the sum; what is left out is not in it. */
    double exact(Totals tally) {
        double weight = Math.max(aim.sumWeight(), BETWEEN_EQUALS * aim.longestWeight());
        return aim.longestWeight() * tally.longest() + weight * tally.total() + idlePenalty * tally.idle();
    }

    /** What a plan is compared by: what is left out first, then the aim itself, then the sum. */
    double exact() {
        int idle = 0;
        double missing = 0;
        for (int r = 0; r < tours.drones; r++) {
            idle += isIdle(r) ? 1 : 0;
        }
        for (int i = 0; i < tours.absent().size(); i++) {
            missing += stakes.leftOut(tours.absent().get(i));
        }
        return exact(new Totals(tours.longest(), tours.total(), idle)) + missing;
    }
}
