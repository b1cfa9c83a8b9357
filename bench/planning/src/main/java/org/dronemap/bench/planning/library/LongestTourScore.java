package org.dronemap.bench.planning.library;

import ai.timefold.solver.core.api.score.buildin.simplelong.SimpleLongScore;
import ai.timefold.solver.core.api.score.calculator.IncrementalScoreCalculator;
import java.util.List;

/**
 * Tells Timefold what tours are worth, from what changed alone: a high norm of their lengths, which also rewards a shorter
 * second-longest tour, and a little of their mean.
 */
public final class LongestTourScore implements IncrementalScoreCalculator<TimefoldSolution, SimpleLongScore> {
    private static final double STEPS_PER_UNIT = 1e5;
    private static final double MEAN_WEIGHT = 0.2;

    private double[][] distances = new double[0][];
    private int waypoints;
    private double[] lengths = new double[0];

    @Override
    public void resetWorkingSolution(TimefoldSolution plan) {
        distances = plan.distances();
        waypoints = plan.waypoints();
        lengths = new double[plan.routes().size()];
        for (TimefoldRoute route : plan.routes()) {
            lengths[route.drone()] = between(route, 0, route.stops().size());
        }
    }

    /** From the stop before the first of a range to the one after its last. */
    private double between(TimefoldRoute route, int from, int to) {
        List<TimefoldStop> stops = route.stops();
        int depot = waypoints + route.drone();
        int last = from > 0 ? stops.get(from - 1).waypoint() : depot;
        double length = 0;
        for (int i = from; i <= to; i++) {
            int next = i < stops.size() ? stops.get(i).waypoint() : depot;
            length += distances[last][next];
            last = next;
        }
        return length;
    }

    @Override
    public void beforeListVariableChanged(Object entity, String variable, int from, int to) {
        TimefoldRoute route = (TimefoldRoute) entity;
        lengths[route.drone()] -= between(route, from, to);
    }

    @Override
    public void afterListVariableChanged(Object entity, String variable, int from, int to) {
        TimefoldRoute route = (TimefoldRoute) entity;
        lengths[route.drone()] += between(route, from, to);
    }

    @Override
    public SimpleLongScore calculateScore() {
        double longest = 0;
        double sum = 0;
        for (double length : lengths) {
            longest = Math.max(longest, length);
            sum += length;
        }
        if (longest <= 0) {
            return SimpleLongScore.ZERO;
        }
        double powers = 0;
        for (double length : lengths) {
            powers += sixteenth(length / longest);
        }
        double norm = longest * Math.sqrt(Math.sqrt(Math.sqrt(Math.sqrt(powers))));
        return SimpleLongScore.of(-Math.round(STEPS_PER_UNIT * (norm + MEAN_WEIGHT * sum / lengths.length)));
    }

    private static double sixteenth(double base) {
        double square = base * base;
        double fourth = square * square;
        double eighth = fourth * fourth;
        return eighth * eighth;
    }

    @Override
    public void beforeEntityAdded(Object entity) {
        throw noOtherChanges();
    }

    @Override
    public void afterEntityAdded(Object entity) {
        throw noOtherChanges();
    }

    @Override
    public void beforeVariableChanged(Object entity, String variable) {
        throw noOtherChanges();
    }

    @Override
    public void afterVariableChanged(Object entity, String variable) {
        throw noOtherChanges();
    }

    @Override
    public void beforeEntityRemoved(Object entity) {
        throw noOtherChanges();
    }

    @Override
    public void afterEntityRemoved(Object entity) {
        throw noOtherChanges();
    }

    private static IllegalStateException noOtherChanges() {
        return new IllegalStateException("only the order of stops changes");
    }
}
