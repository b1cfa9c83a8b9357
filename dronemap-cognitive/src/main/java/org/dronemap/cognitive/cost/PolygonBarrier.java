package org.dronemap.cognitive.cost;

import java.util.List;

/** A polygonal barrier on the planner's plane, convex or not. */
final class PolygonBarrier extends ChartBarrier {
    /** How many times the room a turn may be away from its corner. */
    private static final double LONGEST_MITRE = 2.5;

    /** Of each edge x and y of its beginning and of its end; counter-clockwise. */
    private final double[][] edges;
    /** By how many metres each edge may be bent on the globe. */
    private final double[] bends;

    private final double west;
    private final double east;
    private final double south;
    private final double north;

    /** {@code corners}: x and y, in either sense. */
    PolygonBarrier(double[][] corners, ProjectionError bend, double low, double high, boolean keepIn) {
        super(low, high, keepIn);
        double[][] ring = counterClockwise(corners);
        edges = new double[ring.length][];
        bends = new double[ring.length];
        double[] box = {Double.MAX_VALUE, -Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE};
        double widest = 0;
        for (int i = 0; i < ring.length; i++) {
            double[] next = ring[(i + 1) % ring.length];
            edges[i] = new double[] {ring[i][0], ring[i][1], next[0], next[1]};
            bends[i] = bend.meters(Math.hypot(next[0] - ring[i][0], next[1] - ring[i][1]));
            widest = Math.max(widest, bends[i]);
            box[0] = Math.min(box[0], ring[i][0]);
            box[1] = Math.max(box[1], ring[i][0]);
            box[2] = Math.min(box[2], ring[i][1]);
            box[3] = Math.max(box[3], ring[i][1]);
        }
        west = box[0] - widest;
        east = box[1] + widest;
        south = box[2] - widest;
        north = box[3] + widest;
    }

    private static double[][] counterClockwise(double[][] corners) {
        double twice = 0;
        for (int i = 0; i < corners.length; i++) {
            double[] one = corners[i];
            double[] next = corners[(i + 1) % corners.length];
            twice += one[0] * next[1] - next[0] * one[1];
        }
        double[][] ring = corners.clone();
        if (twice < 0) {
            for (int i = 0; i < ring.length; i++) {
                ring[i] = corners[corners.length - 1 - i];
            }
        }
        return ring;
    }

    @Override
    boolean isFree(double x1, double y1, double x2, double y2, double room) {
        if (isApart(x1, y1, x2, y2, room)) {
            return !isKeepIn();
        }
        for (int i = 0; i < edges.length; i++) {
            double least = room + bends[i];
            if (SegmentDistances.squared(edges[i], x1, y1, x2, y2) <= least * least) {
                return false;
            }
        }
        return contains(x1, y1) == isKeepIn();
    }

    private boolean isApart(double x1, double y1, double x2, double y2, double room) {
        return Math.max(x1, x2) < west - room
                || Math.min(x1, x2) > east + room
                || Math.max(y1, y2) < south - room
                || Math.min(y1, y2) > north + room;
    }

    private boolean contains(double x, double y) {
        boolean inside = false;
        for (double[] edge : edges) {
            if (edge[1] > y != edge[3] > y && x < edge[0] + (y - edge[1]) / (edge[3] - edge[1]) * (edge[2] - edge[0])) {
                inside = !inside;
            }
        }
        return inside;
    }

    /** At each corner that sticks out into where drones fly. */
    @Override
    void turns(double room, FreeSpace free, List<double[]> turns) {
        double outward = isKeepIn() ? -1 : 1;
        for (int i = 0; i < edges.length; i++) {
            int previous = (i + edges.length - 1) % edges.length;
            double[] one = normal(edges[previous]);
            double[] other = normal(edges[i]);
            if ((one[0] * other[1] - one[1] * other[0]) * outward > 0) {
                double beyond = outward * (room + Math.max(bends[i], bends[previous]));
                turn(edges[i], new double[][] {one, other}, beyond, free, turns);
            }
        }
    }

    /** Where the lines beside both edges meet; where that is far out or not free, beside each edge and between. */
    private static void turn(double[] corner, double[][] normals, double beyond, FreeSpace free, List<double[]> turns) {
        double[] middle = {normals[0][0] + normals[1][0], normals[0][1] + normals[1][1]};
        double length = Math.hypot(middle[0], middle[1]);
        boolean blunt = length * LONGEST_MITRE > 2;
        double[] mitre = blunt ? spot(corner, middle, 2 * beyond / (length * length)) : corner;
        if (blunt && free.contains(mitre[0], mitre[1])) {
            turns.add(mitre);
            return;
        }
        turns.add(spot(corner, normals[0], beyond));
        turns.add(spot(corner, normals[1], beyond));
        if (length > 1e-9) {
            turns.add(spot(corner, middle, beyond / length));
        }
    }

    private static double[] spot(double[] corner, double[] direction, double times) {
        return new double[] {corner[0] + direction[0] * times, corner[1] + direction[1] * times};
    }

    /** To the right of an edge: out of the area. */
    private static double[] normal(double[] edge) {
        double length = Math.hypot(edge[2] - edge[0], edge[3] - edge[1]);
        return new double[] {(edge[3] - edge[1]) / length, -(edge[2] - edge[0]) / length};
    }
}
