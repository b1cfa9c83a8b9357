package org.dronemap.core.zone;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlanePolygon;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/**
 * Checks a leg of a predicted route against a zone, with a margin for inaccuracy; refuses in doubt. Nobody knows to the
 * decimetre how a vehicle flies a straight line, and the longer the line the less; a leg must stay away from an edge by
 * what is not known.
 */
final class LegCheck {
    /** Rounding on the wire, and a little. */
    private static final double LEAST_ROOM_METERS = 0.3;

    private static final double LONGEST_LEG_METERS = 1_000_000;
    /** Nothing farther than this from all of a leg needs a closer look. */
    private static final double NEAR_DEGREES = 0.2;

    private static final double NEAREST_POLE_DEGREES = 89;

    private static final double MEAN_EARTH_RADIUS_METERS = 6_371_008.8;

    private final Leg leg;
    private final HeightReferences levels;
    private final LocalPlane plane;
    private final PlaneSegment stretch;

    LegCheck(Leg leg, HeightReferences levels) {
        this.leg = leg;
        this.levels = levels;
        double middle = (leg.from().latitudeDegrees() + leg.to().latitudeDegrees()) / 2;
        this.plane = new LocalPlane(new Geodetic(middle, leg.from().longitudeDegrees()));
        this.stretch = new PlaneSegment(plane.spot(leg.from()), plane.spot(leg.to()));
    }

    /** Names leg, zone and distance; empty when the leg keeps to the zone. */
    Optional<RouteObjection> whyNot(Zone zone) {
        if (zone.shape().inside()) {
            return whyNot(new FlightBounds(zone.shape(), zone.band()), zone.words());
        }
        return isTooLong() ? Optional.of(tooLong(zone.words())) : enters(zone);
    }

    /** The same of bounds that are called so. */
    Optional<RouteObjection> whyNot(FlightBounds bounds, String words) {
        return isTooLong()
                ? Optional.of(tooLong(words))
                : outOfBand(bounds.band(), words).or(() -> leaves(bounds.area(), words));
    }

    private boolean isTooLong() {
        return stretch.lengthMeters() > LONGEST_LEG_METERS;
    }

    private RouteObjection tooLong(String words) {
        return RouteObjection.notCheckable(
                leg.words() + " is longer than 1000 km; it cannot be checked against " + words + ".");
    }

    private Optional<RouteObjection> enters(Zone zone) {
        if (isFar(zone.shape()) || !sharesHeights(zone)) {
            return Optional.empty();
        }
        Contact contact =
                zone.shape() instanceof FenceArea.Circle circle ? meets(circle) : meets(outline(zone.shape()));
        if (contact.beginsInside()) {
            return Optional.of(RouteObjection.forbidden(leg.words() + " begins inside " + named(zone) + "."));
        }
        if (contact.metersToCrossing() < Double.POSITIVE_INFINITY) {
            return Optional.of(RouteObjection.forbidden(
                    leg.words() + " enters " + named(zone) + " after " + meters(contact.metersToCrossing()) + "."));
        }
        return near(contact)
                .map(how -> RouteObjection.forbidden(leg.words() + " passes " + how + " of " + named(zone) + "."));
    }

    private Optional<RouteObjection> leaves(@Nullable FenceArea area, String words) {
        if (area == null) {
            return Optional.empty();
        }
        return leaves(area instanceof FenceArea.Circle circle ? staysIn(circle) : meets(outline(area)), words);
    }

    private Optional<RouteObjection> leaves(Contact contact, String words) {
        if (!contact.beginsInside()) {
            return Optional.of(RouteObjection.forbidden(leg.words() + " begins outside " + words + ", "
                    + meters(contact.startGapMeters()) + " away from it."));
        }
        if (contact.metersToCrossing() < Double.POSITIVE_INFINITY) {
            return Optional.of(RouteObjection.forbidden(
                    leg.words() + " leaves " + words + " after " + meters(contact.metersToCrossing()) + "."));
        }
        return near(contact)
                .map(how -> RouteObjection.forbidden(leg.words() + " comes " + how + " of the edge of " + words + "."));
    }

    private static Optional<String> near(Contact contact) {
        return contact.gapMeters() > contact.roomMeters()
                ? Optional.empty()
                : Optional.of(
                        "within " + meters(contact.gapMeters()) + " (" + meters(contact.roomMeters()) + " are needed)");
    }

    /**
     * Position of a leg relative to the edge of a zone: distances, crossing, and whether it begins inside.
     *
     * @param startGapMeters from the beginning of the leg to the edge
     * @param metersToCrossing along the leg; infinite when it does not cross
     * @param gapMeters the least distance between the two
     * @param roomMeters the distance that is needed for certainty
     */
    private record Contact(
            boolean beginsInside,
            double startGapMeters,
            double metersToCrossing,
            double gapMeters,
            double roomMeters) {}

    private Contact meets(PlanePolygon outline) {
        double crossing = Double.POSITIVE_INFINITY;
        double gap = Double.POSITIVE_INFINITY;
        double room = 0;
        double startGap = Double.POSITIVE_INFINITY;
        for (PlaneSegment edge : outline.edges()) {
            double away = stretch.distanceMeters(edge);
            double needed = roomMeters(stretch.lengthMeters()) + bendMeters(edge.lengthMeters());
            startGap = Math.min(startGap, edge.distanceMeters(stretch.from()));
            if (stretch.crosses(edge)) {
                crossing = Math.min(crossing, stretch.crossingShare(edge) * stretch.lengthMeters());
            }
            if (away - needed < gap - room) {
                gap = away;
                room = needed;
            }
        }
        return new Contact(outline.contains(stretch.from()), startGap, crossing, gap, room);
    }

    private Contact meets(FenceArea.Circle circle) {
        PlaneSegment way = around(circle);
        double radius = circle.radiusMeters();
        double gap = way.distanceMeters(CENTER) - radius;
        double crossing = gap > 0 ? Double.POSITIVE_INFINITY : metersToRim(way, radius);
        double begins = way.from().distanceMeters(CENTER);
        return new Contact(
                begins <= radius, Math.abs(begins - radius), crossing, Math.max(0, gap), circleRoomMeters(radius));
    }

    /** A disc is convex: what begins and ends in it stays in it. */
    private Contact staysIn(FenceArea.Circle circle) {
        PlaneSegment way = around(circle);
        double radius = circle.radiusMeters();
        double begins = way.from().distanceMeters(CENTER);
        double ends = way.to().distanceMeters(CENTER);
        boolean inside = begins <= radius;
        double gap = inside ? radius - Math.max(begins, ends) : begins - radius;
        double crossing = inside && ends > radius
                ? way.lengthMeters() - metersToRim(backwards(way), radius)
                : Double.POSITIVE_INFINITY;
        return new Contact(inside, Math.abs(begins - radius), crossing, Math.max(0, gap), circleRoomMeters(radius));
    }

    private static final PlanePoint CENTER = new PlanePoint(0, 0);

    private PlaneSegment around(FenceArea.Circle circle) {
        return new PlaneSegment(
                LocalPlane.offset(circle.center(), leg.from()), LocalPlane.offset(circle.center(), leg.to()));
    }

    private static PlaneSegment backwards(PlaneSegment way) {
        return new PlaneSegment(way.to(), way.from());
    }

    /** From the beginning of a way outside a disc to where it enters it. */
    private static double metersToRim(PlaneSegment way, double radius) {
        double share = way.nearestShare(CENTER);
        double across = way.at(share).distanceMeters(CENTER);
        double half = Math.sqrt(Math.max(0, radius * radius - across * across));
        return Math.max(0, share * way.lengthMeters() - half);
    }

    private double circleRoomMeters(double radius) {
        return roomMeters(stretch.lengthMeters()) + radius * 1e-5;
    }

    private double roomMeters(double lengthMeters) {
        return LEAST_ROOM_METERS + bendMeters(lengthMeters);
    }

    /** By how much the different straight lines between two places (on map, globe and compass) part on the way. */
    private double bendMeters(double lengthMeters) {
        double steepest = Math.max(
                Math.abs(leg.from().latitudeDegrees()), Math.abs(leg.to().latitudeDegrees()));
        return lengthMeters * lengthMeters * Math.tan(Math.toRadians(steepest)) / (8 * MEAN_EARTH_RADIUS_METERS);
    }

    private PlanePolygon outline(FenceArea shape) {
        if (shape instanceof FenceArea.Polygon polygon) {
            return plane.outline(polygon.corners());
        }
        throw new IllegalArgumentException("no outline of " + shape);
    }

    /** A quick look that spares the close one. */
    private boolean isFar(FenceArea shape) {
        double reach = NEAR_DEGREES + roomMeters(stretch.lengthMeters()) / 100_000;
        if (shape instanceof FenceArea.Circle circle) {
            return apart(List.of(circle.center()), reach + circle.radiusMeters() / 100_000);
        }
        return shape instanceof FenceArea.Polygon polygon && apart(polygon.corners(), reach);
    }

    private boolean apart(List<Geodetic> places, double degrees) {
        double south = Math.min(leg.from().latitudeDegrees(), leg.to().latitudeDegrees()) - degrees;
        double north = Math.max(leg.from().latitudeDegrees(), leg.to().latitudeDegrees()) + degrees;
        // Degrees of longitude are the shorter the nearer to a pole, where no zone is.
        double across = degrees / Math.cos(Math.toRadians(Math.min(NEAREST_POLE_DEGREES, Math.max(-south, north))));
        double way = LocalPlane.eastward(leg.from(), leg.to());
        return AreaExtent.isBeside(
                places,
                new AreaExtent.Box(leg.from(), south, north, Math.min(0, way) - across, Math.max(0, way) + across));
    }

    private boolean sharesHeights(Zone zone) {
        LegHeights.Range range = leg.heights().from(zone.band().reference(), levels);
        return range.lowMeters() <= zone.band().highMeters()
                && range.highMeters() >= zone.band().lowMeters();
    }

    private Optional<RouteObjection> outOfBand(AltitudeBand band, String words) {
        if (!band.isBounded()) {
            return Optional.empty();
        }
        LegHeights.Range range = leg.heights().from(band.reference(), levels);
        if (range.equals(LegHeights.Range.ANY)) {
            return Optional.of(RouteObjection.notCheckable(
                    "How high " + lowerFirst(leg.words()) + " leads cannot be compared with the heights of " + words
                            + " as long as the altitude of the home is not known."));
        }
        if (range.highMeters() > band.highMeters()) {
            return Optional.of(RouteObjection.forbidden(
                    leg.words() + " reaches " + band.words(Math.round(range.highMeters() * 10) / 10.0)
                            + ", over the ceiling of " + words + " at " + band.words(band.highMeters()) + "."));
        }
        if (!leg.heights().toTheGround() && range.lowMeters() < band.lowMeters()) {
            return Optional.of(RouteObjection.forbidden(
                    leg.words() + " goes down to " + band.words(Math.round(range.lowMeters() * 10) / 10.0)
                            + ", under the floor of " + words + " at " + band.words(band.lowMeters()) + "."));
        }
        return Optional.empty();
    }

    /** With its heights, which may be the way round it. */
    private static String named(Zone zone) {
        AltitudeBand band = zone.band();
        if (!band.isBounded()) {
            return zone.words();
        }
        Double floor = band.floorMeters();
        Double ceiling = band.ceilingMeters();
        if (floor == null) {
            return zone.words() + " (up to " + band.words(band.highMeters()) + ")";
        }
        return ceiling == null
                ? zone.words() + " (from " + band.words(floor) + " upwards)"
                : zone.words() + " (from " + String.format(Locale.ROOT, "%.0f", floor) + " to " + band.words(ceiling)
                        + ")";
    }

    private static String lowerFirst(String words) {
        return words.substring(0, 1).toLowerCase(Locale.ROOT) + words.substring(1);
    }

    private static String meters(double meters) {
        if (meters >= 10_000) {
            return String.format(Locale.ROOT, "%.1f km", meters / 1000);
        }
        return String.format(Locale.ROOT, meters < 10 ? "%.1f m" : "%.0f m", meters);
    }
}
