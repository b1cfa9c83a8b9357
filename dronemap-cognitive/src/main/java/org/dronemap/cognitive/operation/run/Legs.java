package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.plan.Stop;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.dronemap.core.mission.MissionItem;

/** Where a mission leads from where a drone is. */
final class Legs {
    private Legs() {}

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

    /** How long it waits where it is or where it flies to, in s. */
    static double hold(Sortie sortie, int passed) {
        List<MissionItem> items = sortie.mission().items();
        return passed < items.size() && items.get(passed) instanceof MissionItem.Waypoint waypoint
                ? waypoint.holdSeconds()
                : 0;
    }

    /** Of the present leg; nothing is too low on the way down. */
    static double lowest(Sortie sortie, int passed) {
        List<MissionItem> items = sortie.mission().items();
        boolean between = passed >= 1
                && passed < items.size()
                && items.get(passed - 1) instanceof MissionItem.Waypoint
                && items.get(passed) instanceof MissionItem.Waypoint;
        return between
                ? Math.min(
                        place((MissionItem.Waypoint) items.get(passed - 1)).altitudeAmslMeters(),
                        place((MissionItem.Waypoint) items.get(passed)).altitudeAmslMeters())
                : Double.NEGATIVE_INFINITY;
    }

    /** How far from the straight line of the present leg, in m; 0 where there is none. */
    static double offMeters(Sortie sortie, int passed, Place at) {
        List<MissionItem> items = sortie.mission().items();
        if (passed < 1
                || passed >= items.size()
                || !(items.get(passed - 1) instanceof MissionItem.Waypoint from)
                || !(items.get(passed) instanceof MissionItem.Waypoint to)) {
            return 0;
        }
        LocalPlane plane = new LocalPlane(from.point());
        Spot end = plane.spot(to.point());
        Spot here = plane.spot(at.point());
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
        Stop stop = tour.stops().get(done);
        double length = Geodesy.distanceMeters(
                stop.way().from().point(), stop.way().to().point());
        double left = Geodesy.distanceMeters(at.point(), stop.way().to().point());
        double share = length < 1 ? 0 : Math.min(1, left / length);
        return tour.usedJoules() - used - (1 - share) * stop.way().joules();
    }
}
