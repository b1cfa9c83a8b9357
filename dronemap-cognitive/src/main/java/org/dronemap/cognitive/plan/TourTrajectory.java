package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlaneSegment;

/** The planned trajectory of one drone as straight pieces, each with its speed and range of heights. Never changes. */
final class TourTrajectory {
    private final Craft craft;
    private final List<Piece> pieces;
    private final double acceleration;

    /**
     * One straight movement.
     *
     * @param low the lowest height it may be at
     * @param peak the greatest speed on it, in m/s
     * @param middle halfway
     * @param east share of what it moves that goes east
     * @param north the same to the north
     * @param reach from there to either end, in metres
     */
    record Piece(
            double fromSeconds,
            double tillSeconds,
            double low,
            double high,
            double peak,
            PlanePoint middle,
            double east,
            double north,
            double reach) {
        /** Whether all of it is farther than that from all of another one: a quick look that spares the close one. */
        boolean isBeyond(Piece other, double meters) {
            double eastward = middle.eastMeters() - other.middle.eastMeters();
            double northward = middle.northMeters() - other.middle.northMeters();
            double near = reach + other.reach + meters;
            return eastward * eastward + northward * northward > near * near;
        }
    }

    private TourTrajectory(Craft craft, List<Piece> pieces) {
        this.craft = craft;
        this.pieces = pieces;
        this.acceleration = craft.performance().speeds().acceleration();
    }

    /** Of a drone that has a tour. */
    static TourTrajectory of(Craft craft, Tour tour, LocalPlane plane) {
        TrajectoryBuilder drawing =
                new TrajectoryBuilder(plane, craft.performance().speeds().acceleration());
        drawing.at(tour.way(0).from(), craft.start().airborne() ? 0 : tour.departsSeconds());
        tour.ways().forEach(drawing::follow);
        if (!craft.lands()) {
            drawing.stay(Double.POSITIVE_INFINITY);
        }
        return new TourTrajectory(craft, drawing.pieces);
    }

    /** Of a drone that waits, flies one way, and stays at its end until a moment. */
    static TourTrajectory of(Craft craft, double since, TourLeg way, double until, LocalPlane plane) {
        TrajectoryBuilder drawing =
                new TrajectoryBuilder(plane, craft.performance().speeds().acceleration());
        drawing.at(way.from(), since);
        drawing.follow(way);
        drawing.stay(until);
        return new TourTrajectory(craft, drawing.pieces);
    }

    Craft craft() {
        return craft;
    }

    /** From when it is in the air. */
    double fromSeconds() {
        return pieces.get(0).fromSeconds();
    }

    double tillSeconds() {
        return pieces.get(pieces.size() - 1).tillSeconds();
    }

    List<Piece> pieces() {
        return pieces;
    }

    /** The number of the first piece that is not over by then; how many there are when it is down. */
    int pieceAt(double seconds) {
        int low = 0;
        int high = pieces.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (pieces.get(middle).tillSeconds() > seconds) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }

    /** How far from the middle of a piece it is, along it: from minus {@code reach} to plus it. */
    double along(Piece piece, double seconds) {
        double total = piece.tillSeconds() - piece.fromSeconds();
        double length = 2 * piece.reach();
        if (length == 0) {
            return 0;
        }
        double since = Math.max(0, Math.min(total, seconds - piece.fromSeconds()));
        boolean secondHalf = since > total / 2;
        double early = secondHalf ? total - since : since;
        double runUp = piece.peak() / acceleration;
        double gone = early < runUp ? acceleration * early * early / 2 : piece.peak() * (early - runUp / 2);
        double left = piece.reach() - Math.min(length, gone);
        return secondHalf ? left : -left;
    }

    /** Puts pieces together. Used once, by one thread. */
    private static final class TrajectoryBuilder {
        private final LocalPlane plane;
        private final double acceleration;
        private final List<Piece> pieces = new ArrayList<>();
        private Place place = new Place(new Geodetic(0, 0), 0);
        private PlanePoint spot = new PlanePoint(0, 0);
        private double seconds;

        TrajectoryBuilder(LocalPlane plane, double acceleration) {
            this.plane = plane;
            this.acceleration = acceleration;
        }

        void at(Place start, double begins) {
            place = start;
            spot = plane.spot(start.point());
            seconds = begins;
        }

        void follow(TourLeg way) {
            stay(way.departsSeconds());
            way.fixes().subList(1, way.fixes().size()).forEach(this::fly);
        }

        void stay(double until) {
            if (until > seconds) {
                double height = place.altitudeAmslMeters();
                pieces.add(new Piece(seconds, until, height, height, 0, spot, 0, 0, 0));
                seconds = until;
            }
        }

        void fly(TimedPlace fix) {
            PlanePoint next = plane.spot(fix.place().point());
            double one = place.altitudeAmslMeters();
            double other = fix.place().altitudeAmslMeters();
            double length = spot.distanceMeters(next);
            pieces.add(new Piece(
                    seconds,
                    fix.seconds(),
                    Math.min(one, other),
                    Math.max(one, other),
                    peak(length, fix.seconds() - seconds),
                    new PlaneSegment(spot, next).at(0.5),
                    length == 0 ? 0 : (next.eastMeters() - spot.eastMeters()) / length,
                    length == 0 ? 0 : (next.northMeters() - spot.northMeters()) / length,
                    length / 2));
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
