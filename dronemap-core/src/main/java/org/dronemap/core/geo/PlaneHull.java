package org.dronemap.core.geo;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The smallest convex area around points of a LocalPlane: straight ways between any two of them stay in it. */
public record PlaneHull(List<PlanePoint> corners) {
    private static final Comparator<PlanePoint> EASTWARDS =
            Comparator.comparingDouble(PlanePoint::eastMeters).thenComparingDouble(PlanePoint::northMeters);

    public PlaneHull {
        corners = List.copyOf(corners);
        if (corners.isEmpty()) {
            throw new IllegalArgumentException("an area around no point");
        }
    }

    /** Along its southern edge and back along its northern one. */
    public static PlaneHull around(List<PlanePoint> points) {
        List<PlanePoint> sorted = points.stream().distinct().sorted(EASTWARDS).toList();
        if (sorted.size() < 3) {
            return new PlaneHull(sorted);
        }
        List<PlanePoint> corners = new ArrayList<>(edge(sorted));
        corners.addAll(edge(sorted.stream().sorted(EASTWARDS.reversed()).toList()));
        return new PlaneHull(corners);
    }

    /** Without its last corner, with which the other edge begins. */
    private static List<PlanePoint> edge(List<PlanePoint> sorted) {
        List<PlanePoint> edge = new ArrayList<>();
        for (PlanePoint next : sorted) {
            while (edge.size() > 1 && !turnsLeft(edge.get(edge.size() - 2), edge.get(edge.size() - 1), next)) {
                edge.remove(edge.size() - 1);
            }
            edge.add(next);
        }
        return edge.subList(0, edge.size() - 1);
    }

    private static boolean turnsLeft(PlanePoint from, PlanePoint over, PlanePoint to) {
        return (over.eastMeters() - from.eastMeters()) * (to.northMeters() - from.northMeters())
                        - (over.northMeters() - from.northMeters()) * (to.eastMeters() - from.eastMeters())
                > 0;
    }

    /** 0 when they overlap. */
    public double distanceMeters(PlaneHull other) {
        if (contains(other.corners.get(0)) || other.contains(corners.get(0))) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (PlaneSegment edge : edges()) {
            for (PlaneSegment another : other.edges()) {
                least = Math.min(least, edge.distanceMeters(another));
            }
        }
        return least;
    }

    private boolean contains(PlanePoint point) {
        return corners.size() > 2 && new PlanePolygon(corners).contains(point);
    }

    private List<PlaneSegment> edges() {
        List<PlaneSegment> edges = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            edges.add(new PlaneSegment(corners.get(i), corners.get((i + 1) % corners.size())));
        }
        return edges;
    }
}
