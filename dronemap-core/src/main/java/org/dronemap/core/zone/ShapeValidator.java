package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
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

    /** Two edges by their numbers, the lower first. */
    private record EdgePair(int one, int other) implements Comparable<EdgePair> {
        @Override
        public int compareTo(EdgePair than) {
            return Comparator.comparingInt(EdgePair::one)
                    .thenComparingInt(EdgePair::other)
                    .compare(this, than);
        }
    }

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

    /**
     * The first two edges that touch. Edges are gone through from west to east, each compared with those alone that reach
     * as far east: of an outline of 650 corners some ten.
     */
    private static Optional<String> crossing(List<PlaneSegment> edges) {
        List<Integer> fromWest = IntStream.range(0, edges.size())
                .boxed()
                .sorted(Comparator.comparingDouble(edge -> west(edges.get(edge))))
                .toList();
        List<Integer> reaching = new ArrayList<>();
        Optional<EdgePair> first = Optional.empty();
        for (int edge : fromWest) {
            double west = west(edges.get(edge));
            reaching.removeIf(other -> east(edges.get(other)) + SAME_METERS < west);
            for (int other : reaching) {
                EdgePair pair = new EdgePair(Math.min(edge, other), Math.max(edge, other));
                if (first.filter(found -> found.compareTo(pair) <= 0).isEmpty() && touch(edges, pair)) {
                    first = Optional.of(pair);
                }
            }
            reaching.add(edge);
        }
        return first.map(pair -> "The edge of the area crosses or touches itself: the edge after corner "
                + (pair.one() + 1) + " and the edge after corner " + (pair.other() + 1) + ".");
    }

    private static double west(PlaneSegment edge) {
        return Math.min(edge.from().eastMeters(), edge.to().eastMeters());
    }

    private static double east(PlaneSegment edge) {
        return Math.max(edge.from().eastMeters(), edge.to().eastMeters());
    }

    private static boolean touch(List<PlaneSegment> edges, EdgePair pair) {
        PlaneSegment one = edges.get(pair.one());
        PlaneSegment other = edges.get(pair.other());
        if (isBeside(one, other)) {
            return false;
        }
        if (pair.other() == pair.one() + 1) {
            return foldsBack(one, other);
        }
        if (pair.one() == 0 && pair.other() == edges.size() - 1) {
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
