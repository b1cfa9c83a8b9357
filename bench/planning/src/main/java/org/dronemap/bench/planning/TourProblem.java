package org.dronemap.bench.planning;

import java.util.Arrays;
import java.util.List;

/**
 * Tours from depots over waypoints and back. Places are numbered: the waypoints 0 to n-1, then each drone's depot.
 *
 * @param longest whether the longest tour shall be short, else the sum of all
 * @param depots of each drone; several may share one
 */
public record TourProblem(Metric metric, boolean longest, List<TourPoint> depots, List<TourPoint> waypoints) {
    public TourProblem {
        depots = List.copyOf(depots);
        waypoints = List.copyOf(waypoints);
        if (depots.isEmpty() || waypoints.isEmpty()) {
            throw new IllegalArgumentException("a problem has at least one depot and one waypoint");
        }
    }

    public int drones() {
        return depots.size();
    }

    public int places() {
        return waypoints.size() + depots.size();
    }

    public int depot(int drone) {
        return waypoints.size() + drone;
    }

    public double distance(int from, int to) {
        return metric.between(spot(from), spot(to));
    }

    private TourPoint spot(int place) {
        return place < waypoints.size() ? waypoints.get(place) : depots.get(place - waypoints.size());
    }

    public double[][] distances() {
        double[][] all = new double[places()][places()];
        for (int from = 0; from < all.length; from++) {
            for (int to = 0; to < all.length; to++) {
                all[from][to] = distance(from, to);
            }
        }
        return all;
    }

    public double length(int drone, int[] order) {
        double length = 0;
        int at = depot(drone);
        for (int waypoint : order) {
            length += distance(at, waypoint);
            at = waypoint;
        }
        return length + distance(at, depot(drone));
    }

    /** Whether every waypoint is visited and, where the sum counts, every drone flies. */
    public boolean isServedBy(int[][] orders) {
        int visits = Arrays.stream(orders).mapToInt(order -> order.length).sum();
        boolean idle = Arrays.stream(orders).anyMatch(order -> order.length == 0);
        return visits == waypoints.size() && (longest || !idle);
    }

    /** What the tours are worth: the longest one's length, or the sum; less is better. */
    public double value(int[][] orders) {
        double most = 0;
        double sum = 0;
        for (int drone = 0; drone < orders.length; drone++) {
            double length = length(drone, orders[drone]);
            most = Math.max(most, length);
            sum += length;
        }
        return longest ? most : sum;
    }
}
