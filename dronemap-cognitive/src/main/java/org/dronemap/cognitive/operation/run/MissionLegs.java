package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Computes for a drone in a mission run which places are ahead, how far it is off its leg, and the energy to go. */
final class MissionLegs {
    private MissionLegs() {}

    /** The places that are ahead, by its items; take-off, landing and return have none of their own. */
    static List<Place> ahead(Sortie sortie, int passed) {
        List<Place> places = new ArrayList<>();
        List<MissionItem> items = sortie.mission().items();
        for (int item = passed; item < items.size(); item++) {
            if (items.get(item) instanceof MissionItem.Waypoint waypoint) {
                places.add(place(waypoint));
            }
        }
        return places;
    }

    static Place place(MissionItem.Waypoint waypoint) {
        return new Place(waypoint.point(), waypoint.altitude().meters());
    }

    /** Not just done, or waited for, where a drone has come to. */
    static boolean isFlown(MissionItem item) {
        return switch (item.kind()) {
            case TAKE_OFF, WAYPOINT, RETURN_TO_LAUNCH, LAND, OTHER -> true;
            case WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD -> false;
        };
    }

    /** Without waiting, where it is when its turn comes. */
    private static boolean isDone(MissionItem item) {
        return !isFlown(item) && item.kind() != MissionItem.Kind.WAIT;
    }

    /** How long it waits where it is or where it flies to, in s. */
    static double hold(Sortie sortie, int passed) {
        List<MissionItem> items = sortie.mission().items();
        double seconds = 0;
        for (int item = passed; item < items.size() && (item == passed || !isFlown(items.get(item))); item++) {
            seconds += hold(items.get(item));
        }
        return seconds;
    }

    /** How long it was to wait at the place that is just behind it, in s: it may have set off a moment ago. */
    static double held(Sortie sortie, int passed) {
        List<MissionItem> items = sortie.mission().items();
        double seconds = 0;
        for (int item = Math.min(passed, items.size()) - 1; item >= 0; item--) {
            seconds += hold(items.get(item));
            if (isFlown(items.get(item))) {
                break;
            }
        }
        return seconds;
    }

    private static double hold(MissionItem item) {
        return switch (item.kind()) {
            case WAYPOINT -> ((MissionItem.Waypoint) item).holdSeconds();
            case WAIT -> ((MissionItem.Wait) item).seconds();
            case TAKE_OFF, RETURN_TO_LAUNCH, LAND, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD, OTHER -> 0;
        };
    }

    /** The item that it is on: of those that belong to the place where it stands, that place. */
    static int first(Sortie sortie, int passed) {
        List<MissionItem> items = sortie.mission().items();
        Leg leg = leg(items, passed);
        if (leg == null || !leg.stands()) {
            return passed;
        }
        int place = passed - 1;
        while (!isFlown(items.get(place))) {
            place--;
        }
        return place;
    }

    /** From a place to the next, or to itself while the drone stands there. */
    private record Leg(MissionItem.Waypoint from, MissionItem.Waypoint to, boolean stands) {}

    private static @Nullable Leg leg(List<MissionItem> items, int passed) {
        int before = Math.min(passed, items.size()) - 1;
        while (before >= 0 && !isFlown(items.get(before))) {
            before--;
        }
        if (before < 0 || !(items.get(before) instanceof MissionItem.Waypoint from)) {
            return null;
        }
        int next = passed;
        while (next < items.size() && isDone(items.get(next))) {
            next++;
        }
        if (next < items.size() && items.get(next).kind() == MissionItem.Kind.WAIT) {
            return new Leg(from, from, true);
        }
        return next < items.size() && items.get(next) instanceof MissionItem.Waypoint to
                ? new Leg(from, to, false)
                : null;
    }

    /** Of the present leg; nothing is too low on the way down. */
    static double lowest(Sortie sortie, int passed) {
        Leg leg = leg(sortie.mission().items(), passed);
        return leg == null
                ? Double.NEGATIVE_INFINITY
                : Math.min(
                        place(leg.from()).altitudeAmslMeters(), place(leg.to()).altitudeAmslMeters());
    }

    /** How far from the straight line of the present leg, in m; 0 where there is none. */
    static double offMeters(Sortie sortie, int passed, Place at) {
        Leg leg = leg(sortie.mission().items(), passed);
        if (leg == null) {
            return 0;
        }
        LocalPlane plane = new LocalPlane(leg.from().point());
        PlanePoint end = plane.spot(leg.to().point());
        PlanePoint here = plane.spot(at.point());
        double length = Math.hypot(end.eastMeters(), end.northMeters());
        double along = length == 0
                ? 0
                : (here.eastMeters() * end.eastMeters() + here.northMeters() * end.northMeters()) / (length * length);
        double share = Math.max(0, Math.min(1, along));
        return Math.hypot(here.eastMeters() - share * end.eastMeters(), here.northMeters() - share * end.northMeters());
    }

    /** What the plan says that the rest draws: of the present way as much as is left of its length. */
    static double joulesToGo(Sortie sortie, int passed, Place at) {
        Tour tour = sortie.tour();
        int done = sortie.done(passed).size();
        double used = done == 0 ? 0 : tour.stops().get(done - 1).usedJoules();
        if (done == tour.stops().size()) {
            return 0;
        }
        TourStop stop = tour.stops().get(done);
        double length = Geodesy.distanceMeters(
                stop.way().from().point(), stop.way().to().point());
        double left = Geodesy.distanceMeters(at.point(), stop.way().to().point());
        double share = length < 1 ? 0 : Math.min(1, left / length);
        return tour.usedJoules() - used - (1 - share) * stop.way().joules();
    }
}
