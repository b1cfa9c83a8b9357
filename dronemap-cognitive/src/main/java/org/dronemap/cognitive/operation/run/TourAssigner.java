package org.dronemap.cognitive.operation.run;

import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Gives a drone of a mission run its tour of a new plan, unless it flies just that already. */
final class TourAssigner {
    private static final double SAME_METERS = 1.5;
    private static final double SAME_HEIGHT_METERS = 0.5;

    private TourAssigner() {}

    /** True when it has to get another mission. */
    static boolean assign(RunTransition draft, PendingReplan request, Craft craft, @Nullable Tour tour) {
        RunDrone drone = draft.drone(craft.id());
        drone.orders().forEach(id -> draft.put(draft.target(id).to(RunWaypoint.State.ASSIGNED, drone.id(), null)));
        boolean up = drone.stage().compareTo(RunDroneStage.STARTING) >= 0;
        if (tour == null || (!up && tour.stops().isEmpty())) {
            return idle(draft, drone);
        }
        Sortie whole = Sortie.of(draft.tally().sortie(), drone.profile().with(craft), tour, request.at(), draft::task);
        Sortie next = TaskReports.withoutDone(draft, whole);
        return up ? inTheAir(draft, drone, next) : onTheGround(draft, drone, next);
    }

    private static boolean idle(RunTransition draft, RunDrone drone) {
        boolean armed = drone.stage() == RunDroneStage.ARMING;
        RunDroneStage stage = armed ? RunDroneStage.RETURNING : RunDroneStage.LANDED;
        draft.put(drone.withNext(null).withSortie(null, 0).to(stage, draft.now()));
        return false;
    }

    private static boolean onTheGround(RunTransition draft, RunDrone drone, Sortie next) {
        Sortie latest = drone.latest();
        if (latest != null && isSame(latest.mission().items(), next.mission().items())) {
            return false;
        }
        // What is under way to it already is brought, and then the newest.
        draft.put(
                drone.issuedCommand() == null
                        ? drone.withNext(next).to(RunDroneStage.UPLOADING, draft.now())
                        : drone.withNext(next));
        return true;
    }

    private static boolean inTheAir(RunTransition draft, RunDrone drone, Sortie next) {
        Sortie sortie = drone.sortie();
        boolean flies = drone.stage() == RunDroneStage.FLYING
                || drone.stage() == RunDroneStage.STARTING
                || (drone.stage() == RunDroneStage.HOLDING && drone.flags().waitsFor() != null);
        if (flies && sortie != null && isSame(draft, sortie, MissionLegs.first(sortie, drone.passed()), next)) {
            draft.put(drone.withSortie(sortie.retimed(next.tour(), next.zero(), drone.passed()), drone.passed())
                    .withNext(null));
            return false;
        }
        draft.put(drone.withNext(next));
        return true;
    }

    /** Without what it visited since that was planned, while it was brought to stand there; empty: nothing. */
    static Optional<Sortie> remaining(RunTransition draft, RunDrone drone, Sortie next, Place place) {
        List<TourStop> stops = next.tour().stops();
        int done = 0;
        while (done < stops.size() && draft.target(stops.get(done).waypoint()).isVisitedBy(drone.id())) {
            done++;
        }
        if (done == 0) {
            return Optional.empty();
        }
        Tour rest = new Tour(
                drone.id(),
                stops.subList(done, stops.size()),
                next.tour().last(),
                next.tour().usedJoules());
        RunDrone.Profile kin = drone.profile().with(drone.craft().with(Start.inFlight(place)));
        return Optional.of(
                TaskReports.withoutDone(draft, Sortie.of(next.number(), kin, rest, next.zero(), draft::task)));
    }

    /** From that item on, with the same still to be done at the same waypoints. */
    private static boolean isSame(RunTransition draft, Sortie had, int from, Sortie gets) {
        List<MissionItem> items = had.mission().items();
        boolean climbs = from == 0 && items.get(0) instanceof MissionItem.TakeOff;
        int first = Math.min(climbs ? 1 : from, items.size());
        List<TaskPart> left = parts(draft, had, first);
        return left.equals(parts(draft, gets, 0))
                && isSame(
                        ways(items.subList(first, items.size())),
                        ways(gets.mission().items()));
    }

    private record TaskPart(String waypoint, int part) {}

    private static List<TaskPart> parts(RunTransition draft, Sortie sortie, int first) {
        return sortie.tasks().stream()
                .filter(task -> task.item() >= first && !TaskReports.isSkipped(draft, task))
                .map(task -> new TaskPart(task.waypoint(), task.part()))
                .toList();
    }

    private static List<MissionItem> ways(List<MissionItem> items) {
        return items.stream().filter(MissionLegs::isFlown).toList();
    }

    /** The same way; how long it waits on it is not compared, since where it is in time is not what it was. */
    private static boolean isSame(List<MissionItem> had, List<MissionItem> gets) {
        if (had.size() != gets.size()) {
            return false;
        }
        for (int item = 0; item < had.size(); item++) {
            if (!isSame(had.get(item), gets.get(item))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isSame(MissionItem one, MissionItem other) {
        if (one.kind() != other.kind()) {
            return false;
        }
        return switch (one.kind()) {
            case WAYPOINT -> isSame((MissionItem.Waypoint) one, (MissionItem.Waypoint) other);
            case TAKE_OFF ->
                isSameHeight(
                        ((MissionItem.TakeOff) one).altitudeMeters(), ((MissionItem.TakeOff) other).altitudeMeters());
            case RETURN_TO_LAUNCH, LAND, WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD, OTHER -> one.equals(other);
        };
    }

    private static boolean isSame(MissionItem.Waypoint here, MissionItem.Waypoint there) {
        return Geodesy.distanceMeters(here.point(), there.point()) < SAME_METERS
                && isSameHeight(here.altitude().meters(), there.altitude().meters());
    }

    private static boolean isSameHeight(double one, double other) {
        return Math.abs(one - other) < SAME_HEIGHT_METERS;
    }
}
