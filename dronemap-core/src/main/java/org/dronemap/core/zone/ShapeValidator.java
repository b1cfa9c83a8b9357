package org.dronemap.core.zone;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.FenceArea;

/** Validates the shape of a zone or of flight bounds: large enough, not too large, and with one clear inside. */
public final class ShapeValidator {
    private static final double LEAST_AREA_SQUARE_METERS = 1;
    private static final double MOST_METERS = 200_000;
    private static final int POLAR_DEGREES = 85;
    /** Corners nearer than this are the same one, and edges nearer than this touch. */
    private static final double SAME_METERS = 0.01;

    private ShapeValidator() {}

    /** Empty when it can be used. */
    public static Optional<String> of(FenceArea shape) {
        if (shape instanceof FenceArea.Circle circle) {
            return polar(List.of(circle.center()));
        }
        return shape instanceof FenceArea.Polygon polygon ? of(polygon.corners()) : Optional.empty();
    }

    private static Optional<String> of(List<Geodetic> corners) {
        PlanePolygon outline = new LocalPlane(corners.get(0)).outline(corners);
        if (outline.extentMeters() > MOST_METERS) {
            return Optional.of("The area is wider than 200 km; divide it. (One that crosses the date line is taken the"
                    + " short way round.)");
        }
        return polar(corners)
                .or(() -> repeated(outline.edges()))
                .or(() -> crossing(outline.edges()))
                .or(() -> tiny(outline));
    }

    private static Optional<String> polar(List<Geodetic> places) {
        return places.stream().anyMatch(place -> Math.abs(place.latitudeDegrees()) > POLAR_DEGREES)
                ? Optional.of("Zones within 5 degrees of a pole are not supported.")
                : Optional.empty();
    }

    private static Optional<String> repeated(List<PlaneSegment> edges) {
        for (int i = 0; i < edges.size(); i++) {
            if (edges.get(i).lengthMeters() < SAME_METERS) {
                return Optional.of(
                        "Corners " + (i + 1) + " and " + ((i + 1) % edges.size() + 1) + " are the same place.");
            }
        }
        return Optional.empty();
    }

    private static Optional<String> crossing(List<PlaneSegment> edges) {
        for (int i = 0; i < edges.size(); i++) {
            for (int j = i + 1; j < edges.size(); j++) {
                if (touch(edges, i, j)) {
                    return Optional.of("The edge of the area crosses or touches itself: the edge after corner "
                            + (i + 1) + " and the edge after corner " + (j + 1) + ".");
                }
            }
        }
        return Optional.empty();
    }

    private static boolean touch(List<PlaneSegment> edges, int i, int j) {
        PlaneSegment one = edges.get(i);
        PlaneSegment other = edges.get(j);
        if (isBeside(one, other)) {
            return false;
        }
        if (j == i + 1) {
            return foldsBack(one, other);
        }
        if (i == 0 && j == edges.size() - 1) {
            return foldsBack(other, one);
        }
        return one.distanceMeters(other) < SAME_METERS;
    }

    /** Most edges of a large outline are far from each other: their rectangles tell. */
    private static boolean isBeside(PlaneSegment one, PlaneSegment other) {
        return isApart(
                        one.from().eastMeters(),
                        one.to().eastMeters(),
                        other.from().eastMeters(),
                        other.to().eastMeters())
                || isApart(
                        one.from().northMeters(),
                        one.to().northMeters(),
                        other.from().northMeters(),
                        other.to().northMeters());
    }

    private static boolean isApart(double from, double to, double otherFrom, double otherTo) {
        return Math.max(from, to) + SAME_METERS < Math.min(otherFrom, otherTo)
                || Math.max(otherFrom, otherTo) + SAME_METERS < Math.min(from, to);
    }

    /** Neighbours share a corner, and nothing else. */
    private static boolean foldsBack(PlaneSegment one, PlaneSegment next) {
        return next.distanceMeters(one.from()) < SAME_METERS || one.distanceMeters(next.to()) < SAME_METERS;
    }

    private static Optional<String> tiny(PlanePolygon outline) {
        double area = outline.areaSquareMeters();
        return area < LEAST_AREA_SQUARE_METERS
                ? Optional.of(String.format(
                        Locale.ROOT, "The area is only %.2f m²; it must be at least 1 m² to be guarded.", area))
                : Optional.empty();
    }
}
