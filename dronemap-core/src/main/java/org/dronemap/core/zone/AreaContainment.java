package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.FenceArea;

/** Checks whether one area lies within another, for access keys made from other keys; shared edges count as inside. */
final class AreaContainment {
    /** What rounding may do to a corner that lies on an edge. */
    private static final double SAME_METERS = 0.001;

    private static final PlanePoint CENTER = new PlanePoint(0, 0);
    /** Halvings until nothing is left of 200 km. */
    private static final int STEPS = 80;

    private AreaContainment() {}

    static boolean holds(FenceArea outer, FenceArea inner) {
        if (outer.equals(inner)) {
            return true;
        }
        if (outer instanceof FenceArea.Circle disc) {
            return inner instanceof FenceArea.Circle circle
                    ? meters(disc.center(), circle.center()) + circle.radiusMeters()
                            <= disc.radiusMeters() + SAME_METERS
                    : corners(inner).stream()
                            .allMatch(corner -> meters(disc.center(), corner) <= disc.radiusMeters() + SAME_METERS);
        }
        LocalPlane plane = new LocalPlane(corners(outer).get(0));
        PlanePolygon outline = plane.outline(corners(outer));
        return inner instanceof FenceArea.Circle circle
                ? holds(outline, plane, corners(outer), circle)
                : plane.outline(corners(inner)).edges().stream().allMatch(edge -> holds(outline, edge));
    }

    private static List<Geodetic> corners(FenceArea area) {
        if (area instanceof FenceArea.Polygon polygon) {
            return polygon.corners();
        }
        throw new IllegalArgumentException("no corners of " + area);
    }

    private static double meters(Geodetic from, Geodetic to) {
        return CENTER.distanceMeters(LocalPlane.offset(from, to));
    }

    /** An area without holes holds whatever edge it holds: each piece between two meetings lies inside or outside. */
    private static boolean holds(PlanePolygon outline, PlaneSegment edge) {
        List<Double> shares = new ArrayList<>(List.of(0.0, 1.0));
        for (PlaneSegment other : outline.edges()) {
            if (edge.crosses(other)) {
                shares.add(edge.crossingShare(other));
            }
            // Where it runs through a corner, or begins to run along an edge.
            shares.add(edge.nearestShare(other.from()));
        }
        shares.sort(null);
        for (int i = 0; i + 1 < shares.size(); i++) {
            if (!covers(outline, edge.at(shares.get(i)))
                    || !covers(outline, edge.at((shares.get(i) + shares.get(i + 1)) / 2))) {
                return false;
            }
        }
        return covers(outline, edge.to());
    }

    private static boolean covers(PlanePolygon outline, PlanePoint spot) {
        return outline.contains(spot)
                || outline.edges().stream().anyMatch(edge -> edge.distanceMeters(spot) <= SAME_METERS);
    }

    private static boolean holds(
            PlanePolygon outline, LocalPlane plane, List<Geodetic> corners, FenceArea.Circle circle) {
        if (!outline.contains(plane.spot(circle.center()))) {
            return false;
        }
        for (int i = 0; i < corners.size(); i++) {
            double away = meters(circle.center(), corners.get(i), corners.get((i + 1) % corners.size()));
            if (away < circle.radiusMeters() - SAME_METERS) {
                return false;
            }
        }
        return true;
    }

    /** From a place to the nearest one of an edge, measured as circles are: no one plane is true to all of a big one. */
    private static double meters(Geodetic center, Geodetic from, Geodetic to) {
        double low = 0;
        double high = 1;
        for (int step = 0; step < STEPS; step++) {
            double third = (high - low) / 3;
            if (meters(center, between(from, to, low + third)) < meters(center, between(from, to, high - third))) {
                high -= third;
            } else {
                low += third;
            }
        }
        return meters(center, between(from, to, (low + high) / 2));
    }

    private static Geodetic between(Geodetic from, Geodetic to, double share) {
        double longitude = from.longitudeDegrees() + share * LocalPlane.eastward(from, to);
        double wrapped = longitude > 180 ? longitude - 360 : longitude < -180 ? longitude + 360 : longitude;
        return new Geodetic(from.latitudeDegrees() + share * (to.latitudeDegrees() - from.latitudeDegrees()), wrapped);
    }
}
