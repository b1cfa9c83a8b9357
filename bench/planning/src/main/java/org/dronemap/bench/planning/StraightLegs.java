package org.dronemap.bench.planning;

import java.util.stream.IntStream;
import org.dronemap.cognitive.cost.Legs;

/** The distances of a problem as our planner's legs: a unit a second, a joule a unit. Never changes. */
final class StraightLegs implements Legs {
    private final Metric metric;
    private final double[] x;
    private final double[] y;

    StraightLegs(TourProblem problem) {
        metric = problem.metric();
        TourPoint[] spots = IntStream.range(0, problem.waypoints().size() + 2 * problem.drones())
                .mapToObj(place -> spot(problem, place))
                .toArray(TourPoint[]::new);
        x = IntStream.range(0, spots.length).mapToDouble(i -> spots[i].x()).toArray();
        y = IntStream.range(0, spots.length).mapToDouble(i -> spots[i].y()).toArray();
    }

    private static TourPoint spot(TourProblem problem, int place) {
        int waypoints = problem.waypoints().size();
        return place < waypoints
                ? problem.waypoints().get(place)
                : problem.depots().get((place - waypoints) / 2);
    }

    @Override
    public int places() {
        return x.length;
    }

    @Override
    public double eastMeters(int place) {
        return x[place];
    }

    @Override
    public double northMeters(int place) {
        return y[place];
    }

    @Override
    public double seconds(int type, int from, int to) {
        return metric.between(x[to] - x[from], y[to] - y[from]);
    }

    @Override
    public double meters(int type, int from, int to) {
        return seconds(type, from, to);
    }

    @Override
    public double joules(int type, int from, int to) {
        return seconds(type, from, to);
    }
}
