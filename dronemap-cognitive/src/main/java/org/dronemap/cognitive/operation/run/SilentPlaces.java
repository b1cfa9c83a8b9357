package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.safety.SafetyTimes;

/** Places where a drone of a mission run that is not heard any more may still hover, and until when. */
final class SilentPlaces {
    /** Between two of them: who keeps off both keeps the least distance from whatever lies between. */
    private static final double STEP_METERS = 12;

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
        return missed && loss != null && hovers(drone) && now.isBefore(freeFrom(loss));
    }

    private static boolean hovers(RunDrone drone) {
        VehicleKind kind = drone.profile().kind();
        return switch (kind) {
            case MULTICOPTER, HELICOPTER, VTOL, UNKNOWN -> true;
            case FIXED_WING, AIRSHIP, ROVER, BOAT, SUBMARINE -> false;
        };
    }

    /** One that waited does so until its battery is empty, should its fail-safe be off. */
    private static Instant freeFrom(RunDrone.LinkLoss loss) {
        Instant empty = loss.lastContact().plus(SafetyTimes.LONGEST_HOVER);
        return loss.flew() || empty.isBefore(loss.flyingUntil()) ? loss.flyingUntil() : empty;
    }

    /** Until when, in words. */
    static String until(RunDrone.LinkLoss loss) {
        return TIME.format(freeFrom(loss));
    }

    /** Where it was heard last, and where it was stopped soon after, if it flew. */
    static List<Place> of(RunDrone drone, RunDrone.LinkLoss loss, Place last) {
        List<Place> places = new ArrayList<>(List.of(last));
        Sortie sortie = drone.sortie();
        if (!loss.flew() || sortie == null) {
            return places;
        }
        double left = SafetyTimes.STOPPED_WITHIN.toSeconds()
                * drone.craft().performance().speeds().cruise();
        LocalPlane plane = new LocalPlane(last.point());
        Place from = last;
        for (Place to : MissionLegs.ahead(sortie, drone.passed())) {
            PlanePoint begin = plane.spot(from.point());
            PlanePoint end = plane.spot(to.point());
            double meters = begin.distanceMeters(end);
            double reach = Math.min(left, meters);
            for (double on = STEP_METERS; on < reach + STEP_METERS && meters > 0; on += STEP_METERS) {
                places.add(between(plane, from, to, Math.min(reach, on) / meters));
            }
            left -= meters;
            if (left <= 0) {
                break;
            }
            from = to;
        }
        return places;
    }

    private static Place between(LocalPlane plane, Place from, Place to, double share) {
        PlanePoint begin = plane.spot(from.point());
        PlanePoint end = plane.spot(to.point());
        PlanePoint there = new PlanePoint(
                begin.eastMeters() + share * (end.eastMeters() - begin.eastMeters()),
                begin.northMeters() + share * (end.northMeters() - begin.northMeters()));
        double climb = to.altitudeAmslMeters() - from.altitudeAmslMeters();
        return new Place(plane.place(there), from.altitudeAmslMeters() + share * climb);
    }
}
