package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.safety.SafetyTimes;

/** Places where a drone of a mission run that is not heard any more may still hover, and until when. */
final class SilentPlaces {
    private static final DateTimeFormatter TIME =
            DateTimeFormatter.ofPattern("HH:mm:ss 'UTC'", Locale.ROOT).withZone(ZoneOffset.UTC);

    private SilentPlaces() {}

    /** Nobody has seen it leave, or come down. */
    static boolean mayHover(RunDrone drone, DroneObservation look, Instant now) {
        return !look.isLive() && look.airborne() && !look.comesDown() && mayHover(drone, now);
    }

    /** The same, of one that was in the air when it was heard last. */
    static boolean mayHover(RunDrone drone, Instant now) {
        RunDrone.LinkLoss loss = drone.flags().linkLoss();
        boolean missed = drone.stage() == RunDroneStage.SILENT || drone.stage() == RunDroneStage.GONE;
        return missed && loss != null && drone.profile().kind().hovers() && now.isBefore(freeFrom(drone, loss));
    }

    /** One that waited does so until its battery is empty, should its fail-safe be off; one that flew is home by then. */
    private static Instant freeFrom(RunDrone drone, RunDrone.LinkLoss loss) {
        return loss.lastContact()
                .plus(loss.flew() ? LostDrones.longest(drone, loss.place(), false) : SafetyTimes.LONGEST_HOVER);
    }

    /** Until when, in words. */
    static String until(RunDrone drone, RunDrone.LinkLoss loss) {
        return TIME.format(freeFrom(drone, loss));
    }

    /** Straight pieces of the way on which it may stand: just where it was heard last, unless it flew. */
    static List<Piece> of(RunDrone drone, RunDrone.LinkLoss loss, Place last) {
        Sortie sortie = drone.sortie();
        if (!loss.flew() || sortie == null) {
            return List.of(new Piece(last, last));
        }
        List<Piece> pieces = new ArrayList<>();
        double left = SafetyTimes.STOPPED_WITHIN.toSeconds()
                * drone.craft().performance().speeds().cruise();
        Place from = last;
        for (Place to : MissionLegs.ahead(sortie, drone.passed())) {
            double meters = Geodesy.distanceMeters(from.point(), to.point());
            pieces.add(new Piece(from, meters <= left ? to : between(from, to, left / meters)));
            left -= meters;
            if (left <= 0) {
                break;
            }
            from = to;
        }
        return pieces.isEmpty() ? List.of(new Piece(last, last)) : pieces;
    }

    private static Place between(Place from, Place to, double share) {
        LocalPlane plane = new LocalPlane(from.point());
        PlanePoint there = new PlaneSegment(plane.spot(from.point()), plane.spot(to.point())).at(share);
        double climb = to.altitudeAmslMeters() - from.altitudeAmslMeters();
        return new Place(plane.place(there), from.altitudeAmslMeters() + share * climb);
    }

    /** A straight piece of a way; both ends may be one place. */
    record Piece(Place from, Place to) {
        double low() {
            return Math.min(from.altitudeAmslMeters(), to.altitudeAmslMeters());
        }

        double high() {
            return Math.max(from.altitudeAmslMeters(), to.altitudeAmslMeters());
        }

        double distanceMeters(Place other) {
            LocalPlane plane = new LocalPlane(from.point());
            return way(plane).distanceMeters(plane.spot(other.point()));
        }

        /** All that is nearer than that, and its corners. */
        FenceArea around(double meters) {
            LocalPlane plane = new LocalPlane(from.point());
            PlaneSegment way = way(plane);
            double length = way.from().distanceMeters(way.to());
            if (length < 1) {
                return new FenceArea.Circle(false, from.point(), meters);
            }
            double east = meters * (way.to().eastMeters() - way.from().eastMeters()) / length;
            double north = meters * (way.to().northMeters() - way.from().northMeters()) / length;
            List<Geodetic> corners = Stream.of(
                            moved(way.from(), -east - north, -north + east),
                            moved(way.from(), -east + north, -north - east),
                            moved(way.to(), east + north, north - east),
                            moved(way.to(), east - north, north + east))
                    .map(plane::place)
                    .toList();
            return new FenceArea.Polygon(false, corners);
        }

        private static PlanePoint moved(PlanePoint spot, double east, double north) {
            return new PlanePoint(spot.eastMeters() + east, spot.northMeters() + north);
        }

        private PlaneSegment way(LocalPlane plane) {
            return new PlaneSegment(plane.spot(from.point()), plane.spot(to.point()));
        }
    }
}
