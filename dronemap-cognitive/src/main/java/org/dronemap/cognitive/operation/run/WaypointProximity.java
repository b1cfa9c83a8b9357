package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.mission.MissionItem;

/** Tells whether a mission run's drone will reach its next waypoint before it can stop, or has stopped just short. */
final class WaypointProximity {
    /** It is there before it would stand: less than a second. */
    private static final double JUST_METERS = 4;
    /** So far from where it was to be one comes to stand that was stopped on its last metres. */
    private static final double SHORT_METERS = 8;
    /** Who brakes, and is there so soon, would come to stand about there whatever it is told. */
    private static final double BRAKES_SECONDS = 3;

    private static final double LEVEL_METERS = 1.5;
    private static final double SAME_METERS = 1.5;
    /** Who has not moved for that long comes to nothing. */
    private static final Duration STANDS = Duration.ofSeconds(1);

    private WaypointProximity() {}

    /** Whether it is there in a moment, and its next mission would begin with just that waypoint. */
    static boolean isBefore(RunTransition draft, RunDrone drone, Sortie next, DroneObservation look) {
        Optional<String> heads = heads(draft, drone, look, JUST_METERS);
        return heads.isPresent()
                && heads.equals(
                        next.tour().stops().stream().map(TourStop::waypoint).findFirst());
    }

    /** Whether it comes to a waypoint so soon that it could not be called away from it any more. */
    static boolean isDue(RunTransition draft, RunDrone drone, DroneObservation look) {
        return heads(draft, drone, look, Math.max(JUST_METERS, brakesMeters(look)))
                .isPresent();
    }

    /** Evenly, it flies half of its speed on average. */
    private static double brakesMeters(DroneObservation look) {
        Double speed = look.speed();
        return speed == null ? 0 : Math.min(SHORT_METERS, BRAKES_SECONDS * speed / 2);
    }

    /** The waypoint that it flies to, if it is so near; not on a way round something before. */
    private static Optional<String> heads(RunTransition draft, RunDrone drone, DroneObservation look, double meters) {
        Sortie sortie = drone.sortie();
        Place here = look.place();
        boolean comes = look.isOnMission() && look.still().compareTo(STANDS) < 0;
        if (sortie == null || here == null || !comes) {
            return Optional.empty();
        }
        List<MissionItem> items = sortie.mission().items();
        return sortie.ahead(drone.passed()).stream().findFirst().filter(id -> {
            Place there = draft.target(id).waypoint().place();
            return drone.passed() < items.size()
                    && items.get(drone.passed()) instanceof MissionItem.Waypoint item
                    && Geodesy.distanceMeters(item.point(), there.point()) < SAME_METERS
                    && isNear(here, there, meters);
        });
    }

    /** The first of its orders, if it stands where it was stopped on its last metres there. */
    static List<String> stoppedAt(RunTransition draft, RunDrone drone, Place here) {
        return drone.orders().stream()
                .limit(1)
                .filter(id -> isNear(here, draft.target(id).waypoint().place(), SHORT_METERS))
                .toList();
    }

    private static boolean isNear(Place here, Place there, double meters) {
        return Geodesy.distanceMeters(here.point(), there.point()) < meters
                && Math.abs(here.altitudeAmslMeters() - there.altitudeAmslMeters()) < LEVEL_METERS;
    }
}
