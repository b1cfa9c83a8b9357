package org.dronemap.cognitive.follow;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;

/**
 * The area that a following drone may be guided in: within all keep-in areas, outside all others, with a margin.
 * Immutable.
 */
public final class FlyableArea {
    /** Room without an edge. */
    public static final FlyableArea EVERYWHERE = new FlyableArea(List.of(), 0);

    private static final int STEPS = 200;
    private static final double CLOSE = 0.05;
    private static final double BESIDE = 0.01;

    private final List<Edge> edges;
    private final double marginMeters;

    /** An area's edge; {@code inside}: it is to stay in. */
    private record Edge(PlanePolygon outline, List<PlaneSegment> sides, boolean inside) {
        /** Metres to the edge, negative beyond it. */
        double clearance(PlanePoint spot) {
            double least = Double.POSITIVE_INFINITY;
            for (PlaneSegment side : sides) {
                least = Math.min(least, side.distanceMeters(spot));
            }
            return outline.contains(spot) == inside ? least : -least;
        }

        PlanePoint nearest(PlanePoint spot) {
            PlanePoint best = spot;
            double least = Double.POSITIVE_INFINITY;
            for (PlaneSegment side : sides) {
                PlanePoint one = side.at(side.nearestShare(spot));
                double meters = one.distanceMeters(spot);
                if (meters < least) {
                    least = meters;
                    best = one;
                }
            }
            return best;
        }
    }

    private FlyableArea(List<Edge> edges, double marginMeters) {
        this.edges = List.copyOf(edges);
        this.marginMeters = marginMeters;
    }

    /** Areas by their corners; {@code near}: what the filter of the target was made with. */
    public static FlyableArea of(
            Geodetic near, List<List<Geodetic>> stayIn, List<List<Geodetic>> keepOut, double marginMeters) {
        LocalPlane plane = new LocalPlane(near);
        List<Edge> edges = new ArrayList<>();
        stayIn.forEach(corners -> edges.add(edge(plane, corners, true)));
        keepOut.forEach(corners -> edges.add(edge(plane, corners, false)));
        return new FlyableArea(edges, marginMeters);
    }

    private static Edge edge(LocalPlane plane, List<Geodetic> corners, boolean inside) {
        PlanePolygon outline = plane.outline(corners);
        return new Edge(outline, outline.edges(), inside);
    }

    /** Metres that are left before it is too near an edge; negative: it is. */
    double clearance(PlanePoint spot) {
        double least = Double.POSITIVE_INFINITY;
        for (Edge edge : edges) {
            least = Math.min(least, edge.clearance(spot));
        }
        return least - marginMeters;
    }

    /** A spot with room, near this one; this one if it has, or if none is found. */
    PlanePoint nearest(PlanePoint spot) {
        PlanePoint now = spot;
        for (int i = 0; i < 8 && clearance(now) < 0; i++) {
            for (Edge edge : edges) {
                now = pushed(edge, now);
            }
        }
        return clearance(now) < -BESIDE ? spot : now;
    }

    private PlanePoint pushed(Edge edge, PlanePoint spot) {
        double clearance = edge.clearance(spot);
        if (clearance >= marginMeters) {
            return spot;
        }
        PlanePoint at = edge.nearest(spot);
        double away = Math.signum(clearance) * Math.max(BESIDE, at.distanceMeters(spot));
        double share = (marginMeters + BESIDE) / away;
        return new PlanePoint(
                at.eastMeters() + (spot.eastMeters() - at.eastMeters()) * share,
                at.northMeters() + (spot.northMeters() - at.northMeters()) * share);
    }

    /** How much of the straight way to a spot has room, 0 to 1. */
    double clearShare(PlanePoint from, PlanePoint to) {
        double length = from.distanceMeters(to);
        if (edges.isEmpty() || length == 0) {
            return 1;
        }
        PlaneSegment way = new PlaneSegment(from, to);
        double gone = 0;
        for (int i = 0; i < STEPS && gone < length; i++) {
            double clear = clearance(way.at(gone / length));
            if (clear < CLOSE) {
                // Along an edge, or away from it, there is room though it is close.
                double next = Math.min(length, gone + CLOSE);
                if (clear < -CLOSE || clearance(way.at(next / length)) < Math.min(clear, 0)) {
                    return gone / length;
                }
                gone = next;
            } else {
                gone += clear;
            }
        }
        return Math.min(1, gone / length);
    }
}
