package org.dronemap.core.geo;

import java.util.ArrayList;
import java.util.List;

/** A closed polygon on a LocalPlane. */
public record PlanePolygon(List<PlanePoint> corners) {
    public PlanePolygon {
        corners = List.copyOf(corners);
        if (corners.size() < 3) {
            throw new IllegalArgumentException("an area has at least 3 corners, not " + corners.size());
        }
    }

    /** Edge i leads from corner i to the one after it. */
    public List<PlaneSegment> edges() {
        List<PlaneSegment> edges = new ArrayList<>(corners.size());
        for (int i = 0; i < corners.size(); i++) {
            edges.add(new PlaneSegment(corners.get(i), corners.get((i + 1) % corners.size())));
        }
        return edges;
    }

    /** By counting how often a ray to the east meets the edge; on the edge itself either answer may come. */
    public boolean contains(PlanePoint spot) {
        boolean inside = false;
        for (int i = 0; i < corners.size(); i++) {
            PlanePoint one = corners.get(i);
            PlanePoint next = corners.get((i + 1) % corners.size());
            boolean spans = one.northMeters() > spot.northMeters() != next.northMeters() > spot.northMeters();
            if (spans && spot.eastMeters() < eastAt(one, next, spot.northMeters())) {
                inside = !inside;
            }
        }
        return inside;
    }

    private static double eastAt(PlanePoint one, PlanePoint next, double northMeters) {
        double share = (northMeters - one.northMeters()) / (next.northMeters() - one.northMeters());
        return one.eastMeters() + share * (next.eastMeters() - one.eastMeters());
    }

    public double areaSquareMeters() {
        double twice = 0;
        PlanePoint base = corners.get(0);
        for (int i = 1; i + 1 < corners.size(); i++) {
            PlanePoint one = corners.get(i);
            PlanePoint next = corners.get(i + 1);
            twice += (one.eastMeters() - base.eastMeters()) * (next.northMeters() - base.northMeters())
                    - (one.northMeters() - base.northMeters()) * (next.eastMeters() - base.eastMeters());
        }
        return Math.abs(twice) / 2;
    }

    /** From its westernmost to its easternmost corner, or south to north, whichever is more. */
    public double extentMeters() {
        double west = Double.POSITIVE_INFINITY;
        double east = Double.NEGATIVE_INFINITY;
        double south = Double.POSITIVE_INFINITY;
        double north = Double.NEGATIVE_INFINITY;
        for (PlanePoint corner : corners) {
            west = Math.min(west, corner.eastMeters());
            east = Math.max(east, corner.eastMeters());
            south = Math.min(south, corner.northMeters());
            north = Math.max(north, corner.northMeters());
        }
        return Math.max(east - west, north - south);
    }
}
