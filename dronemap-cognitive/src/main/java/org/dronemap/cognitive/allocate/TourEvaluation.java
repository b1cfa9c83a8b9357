package org.dronemap.cognitive.allocate;

/** Evaluates one tour leg by leg: its duration and energy, with waits for time windows and lateness for them. */
final class TourEvaluation {
    private final LegCosts costs;
    private final int drone;
    private double seconds;
    private double sum;
    private double joules;
    private double lateSeconds;

    TourEvaluation(LegCosts costs, int drone) {
        this.costs = costs;
        this.drone = drone;
        seconds = costs.readySeconds(drone);
    }

    TourEvaluation copy() {
        TourEvaluation copy = new TourEvaluation(costs, drone);
        copy.seconds = seconds;
        copy.sum = sum;
        copy.joules = joules;
        copy.lateSeconds = lateSeconds;
        return copy;
    }

    /** Flies on to a place and serves it. */
    void fly(int from, int to) {
        double leg = costs.seconds(drone, from, to);
        double begins = seconds + leg - costs.serviceSeconds(to);
        double waits = Math.max(0, costs.opensSeconds(to) - begins);
        lateSeconds += Math.max(0, begins + waits - costs.closesSeconds(to));
        seconds += leg + waits;
        double drawn = 0;
        if (costs.limited() || costs.sumsJoules()) {
            drawn = costs.joules(drone, from, to) + waits * costs.watts(to);
        }
        joules += drawn;
        sum += costs.sumsJoules() ? drawn : costs.sumOf(drone, from, to, leg + waits);
    }

    /** On the plan's clock. */
    double seconds() {
        return seconds;
    }

    /** What the aim sums; waiting counts as time and as energy. */
    double sum() {
        return sum;
    }

    double joules() {
        return joules;
    }

    /** Whether a window had closed. */
    boolean late() {
        return lateSeconds > 0;
    }

    /** After closed windows, in all. */
    double lateSeconds() {
        return lateSeconds;
    }
}
