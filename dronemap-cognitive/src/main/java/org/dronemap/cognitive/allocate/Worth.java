package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import org.dronemap.cognitive.cost.Aim;
import org.dronemap.cognitive.cost.Instance;
import org.dronemap.cognitive.cost.Visit;

/**
 * What tours are worth to the search; less is better. In place of the longest tour it looks at a high norm of all, which
 * also tells two plans apart whose longest tours are equal, and at a little of the sum even where nobody asked for it.
 */
final class Worth {
    /** The norm; powers of it are six multiplications. */
    private static final int NORM = 64;
    /** How much a sum that nobody asked for weighs, shared by the drones. */
    private static final double TIDINESS = 0.15;

    /** Of two plans with equally long longest tours the one with the smaller sum is better. */
    private static final double BETWEEN_EQUALS = 1e-9;

    private final Tours tours;
    private final Costs costs;
    private final Aim aim;
    private final double sumWeight;
    private final double[] leftOut;
    private final double idlePenalty;
    private final double[] known;
    private final double[] powers;
    private final double[] slopes;
    private double reference = 1;
    private double inverse = 1;
    private double slope;

    Worth(Tours tours, Costs costs, Instance instance) {
        this.tours = tours;
        this.costs = costs;
        aim = instance.aim();
        sumWeight = Math.max(aim.sumWeight(), TIDINESS * aim.longestWeight() / tours.drones);
        double most = worstPlan();
        double least =
                instance.visits().stream().mapToDouble(Visit::priority).min().orElse(1);
        leftOut = instance.visits().stream()
                .mapToDouble(visit -> most * visit.priority() / least)
                .toArray();
        idlePenalty = aim.everyDrone() ? most : 0;
        known = new double[tours.drones];
        powers = new double[tours.drones];
        slopes = new double[tours.drones];
        rescale();
    }

    /** More than any plan costs that calls at each waypoint by itself, so that leaving one out never pays. */
    private double worstPlan() {
        double all = 1;
        for (int waypoint = 0; waypoint < tours.waypoints; waypoint++) {
            double worst = 0;
            for (int r = 0; r < tours.drones; r++) {
                int start = tours.start(r);
                int end = tours.end(r);
                double alone = costs.seconds(r, start, waypoint) + costs.seconds(r, waypoint, end);
                double its = aim.longestWeight() * alone
                        + sumWeight * (costs.sumOf(r, start, waypoint, alone) + costs.sumOf(r, waypoint, end, alone));
                worst = Double.isFinite(its) ? Math.max(worst, its) : worst;
            }
            all += worst;
        }
        return 10 * all;
    }

    /** Measures norms relative to the longest tour of now, so that no power overflows. */
    final void rescale() {
        double longest = longest();
        reference = longest > 0 ? longest : 1;
        inverse = 1 / reference;
        Arrays.fill(known, Double.NaN);
    }

    /** A drone in the air comes down somewhere, waypoints or not; one on the ground stays there. */
    private boolean flies(int r) {
        return tours.size(r) > 0 || costs.mustFly(r);
    }

    private double sum(int r) {
        return flies(r) ? tours.sum(r) : 0;
    }

    private double power(int r) {
        double seconds = flies(r) ? tours.seconds(r) : 0;
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
    double now() {
        double norm = 0;
        double sum = 0;
        for (int r = 0; r < tours.drones; r++) {
            norm += power(r);
            sum += sumWeight * sum(r) + (tours.size(r) == 0 ? idlePenalty : 0);
        }
        for (int i = 0; i < tours.absent().size(); i++) {
            sum += leftOut[tours.absent().get(i)];
        }
        double root = reference * Math.pow(norm, 1.0 / NORM);
        slope = norm > 0 ? aim.longestWeight() * root / norm / NORM : 0;
        return aim.longestWeight() * root + sum;
    }

    /**
     * By how much the worth would change about, judged by the tours when {@link #now()} was last asked; infinite when that
     * is surely no less than a limit.
     */
    double insertion(int r, double moreSeconds, double moreSum, double limit) {
        double straight = tours.sum(r) - sum(r);
        double change = sumWeight * (moreSum + straight) - (tours.size(r) == 0 ? idlePenalty : 0);
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

    /** When the last tour ends, in seconds on the plan's clock; drones that stay on the ground end none. */
    double longest() {
        double longest = 0;
        for (int r = 0; r < tours.drones; r++) {
            longest = flies(r) ? Math.max(longest, tours.seconds(r)) : longest;
        }
        return longest;
    }

    double total() {
        double total = 0;
        for (int r = 0; r < tours.drones; r++) {
            total += sum(r);
        }
        return total;
    }

    double leftOut(int waypoint) {
        return leftOut[waypoint];
    }

    /** What counts of a plan: its longest tour in seconds, what the aim sums, and how many drones stay idle. */
    record Tally(double longest, double total, int idle) {
        Tally with(double seconds, double sum) {
            return new Tally(Math.max(longest, seconds), total + sum, idle);
        }

        Tally withIdle() {
            return new Tally(longest, total, idle + 1);
        }
    }

    /** The aim itself, then the sum; what is left out is not in it. */
    double exact(Tally tally) {
        double weight = Math.max(aim.sumWeight(), BETWEEN_EQUALS * aim.longestWeight());
        return aim.longestWeight() * tally.longest() + weight * tally.total() + idlePenalty * tally.idle();
    }

    /** What a plan is compared by: what is left out first, then the aim itself, then the sum. */
    double exact() {
        int idle = 0;
        double missing = 0;
        for (int r = 0; r < tours.drones; r++) {
            idle += tours.size(r) == 0 ? 1 : 0;
        }
        for (int i = 0; i < tours.absent().size(); i++) {
            missing += leftOut[tours.absent().get(i)];
        }
        return exact(new Tally(longest(), total(), idle)) + missing;
    }
}
