package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;

/**
 * Where one drone is at each moment that it is in the air: pieces, one after the other, on each of which it moves
 * straight, gathering speed and braking, at any height between those of its ends. Never changes.
 */
final class Trace {
    private final DroneTime time;
    private final List<Piece> pieces;
    private final double acceleration;

    /** From when to when it is in the air. */
    private record DroneTime(Craft craft, double fromSeconds, double tillSeconds) {}

    /** {@code peak}: the greatest speed on it, in m/s. */
    record Piece(Spot from, Spot to, double fromSeconds, double tillSeconds, double low, double high, double peak) {}

    private Trace(DroneTime time, List<Piece> pieces, double acceleration) {
        this.time = time;
        this.pieces = pieces;
        this.acceleration = acceleration;
    }

    /** Of a drone that has a tour. */
    static Trace of(Craft craft, Tour tour, LocalPlane plane) {
        Drawing drawing = new Drawing(plane, craft.performance().speeds().acceleration());
        double begins = craft.start().airborne() ? 0 : tour.departsSeconds();
        drawing.at(tour.ways().get(0).from(), begins);
        for (Way way : tour.ways()) {
            drawing.stay(way.departsSeconds());
            way.fixes().subList(1, way.fixes().size()).forEach(drawing::fly);
        }
        double ends = tour.endsSeconds();
        if (!craft.lands()) {
            drawing.stay(Double.POSITIVE_INFINITY);
            ends = Double.POSITIVE_INFINITY;
        }
        return new Trace(
                new DroneTime(craft, begins, ends),
                drawing.pieces,
                craft.performance().speeds().acceleration());
    }

    Craft craft() {
        return time.craft();
    }

    double fromSeconds() {
        return time.fromSeconds();
    }

    double tillSeconds() {
        return time.tillSeconds();
    }

    List<Piece> pieces() {
        return pieces;
    }

    /** Where it is on a piece. */
    Spot at(Piece piece, double seconds) {
        double total = piece.tillSeconds() - piece.fromSeconds();
        double length = piece.from().distanceMeters(piece.to());
        if (length == 0) {
            return piece.from();
        }
        double since = Math.max(0, Math.min(total, seconds - piece.fromSeconds()));
        boolean secondHalf = since > total / 2;
        double early = secondHalf ? total - since : since;
        double runUp = Double.isInfinite(acceleration) ? 0 : piece.peak() / acceleration;
        double gone = early < runUp ? acceleration * early * early / 2 : piece.peak() * (early - runUp / 2);
        double share = Math.min(1, gone / length);
        double whole = secondHalf ? 1 - share : share;
        return new Spot(
                piece.from().eastMeters()
                        + whole * (piece.to().eastMeters() - piece.from().eastMeters()),
                piece.from().northMeters()
                        + whole * (piece.to().northMeters() - piece.from().northMeters()));
    }

    /** Puts pieces together. Used once, by one thread. */
    private static final class Drawing {
        private final LocalPlane plane;
        private final double acceleration;
        private final List<Piece> pieces = new ArrayList<>();
        private Place place = new Place(new Geodetic(0, 0), 0);
        private Spot spot = new Spot(0, 0);
        private double seconds;

        Drawing(LocalPlane plane, double acceleration) {
            this.plane = plane;
            this.acceleration = acceleration;
        }

        void at(Place start, double begins) {
            place = start;
            spot = plane.spot(start.point());
            seconds = begins;
        }

        void stay(double until) {
            if (until > seconds) {
                double height = place.altitudeAmslMeters();
                pieces.add(new Piece(spot, spot, seconds, until, height, height, 0));
                seconds = until;
            }
        }

        void fly(Fix fix) {
            Spot next = plane.spot(fix.place().point());
            double one = place.altitudeAmslMeters();
            double other = fix.place().altitudeAmslMeters();
            double peak = peak(spot.distanceMeters(next), fix.seconds() - seconds);
            pieces.add(new Piece(spot, next, seconds, fix.seconds(), Math.min(one, other), Math.max(one, other), peak));
            place = fix.place();
            spot = next;
            seconds = fix.seconds();
        }

        /** With which it covers that length in that time, from standstill to standstill. */
        private double peak(double meters, double duration) {
            if (meters == 0 || duration <= 0) {
                return 0;
            }
            if (Double.isInfinite(acceleration)) {
                return meters / duration;
            }
            double most = acceleration * duration;
            return (most - Math.sqrt(Math.max(0, most * most - 4 * acceleration * meters))) / 2;
        }
    }
}
