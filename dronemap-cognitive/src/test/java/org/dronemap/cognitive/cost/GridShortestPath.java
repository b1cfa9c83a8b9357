package org.dronemap.cognitive.cost;

import java.util.Arrays;
import java.util.Comparator;
import java.util.PriorityQueue;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;

/** The shortest way by brute force: over a fine grid of spots that are all clear of what is in the way. */
final class GridShortestPath {
    private static final int[][] STEPS = {
        {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1},
        {-2, -1}, {-1, -2}, {1, -2}, {2, -1}
    };

    private final int side;
    private final double cell;
    private final boolean[] free;

    /** {@code room}: between each spot and what is in the way, beside half a step. */
    GridShortestPath(RandomZones field, double cell, double room) {
        this.cell = cell;
        this.side = (int) (2 * RandomZones.HALF_METERS / cell) + 1;
        this.free = new boolean[side * side];
        PreparedGeometry taken = PreparedGeometryFactory.prepare(field.taken(room + 1.12 * cell));
        for (int i = 0; i < free.length; i++) {
            free[i] = !taken.intersects(RandomZones.SHAPES.createPoint(new Coordinate(x(i), y(i))));
        }
    }

    private double x(int spot) {
        return spot % side * cell - RandomZones.HALF_METERS;
    }

    private double y(int spot) {
        return spot / side * cell - RandomZones.HALF_METERS;
    }

    private record Reached(int spot, double meters) {}

    /** Infinite where it finds none. */
    double meters(Coordinate from, Coordinate to) {
        double[] meters = new double[free.length];
        Arrays.fill(meters, Double.POSITIVE_INFINITY);
        int start = spot(from);
        int end = spot(to);
        if (!free[start] || !free[end]) {
            return Double.POSITIVE_INFINITY;
        }
        PriorityQueue<Reached> next = new PriorityQueue<>(Comparator.comparingDouble(Reached::meters));
        meters[start] = 0;
        next.add(new Reached(start, 0));
        for (Reached at = next.poll(); at != null && at.spot() != end; at = next.poll()) {
            if (at.meters() == meters[at.spot()]) {
                spread(at, meters, next);
            }
        }
        return meters[end];
    }

    private void spread(Reached at, double[] meters, PriorityQueue<Reached> next) {
        for (int[] step : STEPS) {
            int column = at.spot() % side + step[0];
            int row = at.spot() / side + step[1];
            if (column < 0 || row < 0 || column >= side || row >= side || !free[row * side + column]) {
                continue;
            }
            double length = at.meters() + cell * Math.hypot(step[0], step[1]);
            if (length < meters[row * side + column]) {
                meters[row * side + column] = length;
                next.add(new Reached(row * side + column, length));
            }
        }
    }

    private int spot(Coordinate place) {
        int column = (int) Math.round((place.x + RandomZones.HALF_METERS) / cell);
        int row = (int) Math.round((place.y + RandomZones.HALF_METERS) / cell);
        return row * side + column;
    }

    double cell() {
        return cell;
    }
}
