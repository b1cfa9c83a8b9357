package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.zone.AltitudeBand;

/** Turns drones that hover where a mission run cannot move them into barriers, so that new plans lead round them. */
final class DroneObstacles {
    private static final Duration STANDS = Duration.ofSeconds(5);
    /** Beside the least distance, so that nobody is held again for it: what the look ahead asks for, and a little. */
    private static final double ROOM_METERS = 2.5;
    /** Who is nearer than that beyond the rim cannot be led round it. */
    private static final double AT_THE_RIM_METERS = 1;
    /** Noted of a drone that plans lead round. */
    private static final RunTrigger LED_ROUND = RunTrigger.TOO_NEAR;

    private DroneObstacles() {}

    /** What the fences of the run are for this plan alone; those drones are noted. */
    static List<Barrier> barriers(RunTransition draft, List<DroneObservation> looks, Collection<Craft> crafts) {
        List<Barrier> barriers = new ArrayList<>(draft.setting().barriers());
        for (DroneObservation look : looks) {
            RunDrone drone = draft.drone(look.drone());
            Place place = look.place();
            if (place == null || !stands(drone, look)) {
                continue;
            }
            Barrier barrier = barrier(drone, place, draft.setting().rules().separation(), crafts);
            if (!barrier.drones().isEmpty()) {
                barriers.add(barrier);
                note(draft, drone, true);
            }
        }
        return barriers;
    }

    private static Barrier barrier(RunDrone drone, Place place, Separation separation, Collection<Craft> crafts) {
        double radius = separation.horizontalMeters() + ROOM_METERS;
        double amsl = place.altitudeAmslMeters();
        double low = Math.max(Altitude.LOWEST_PLANNED_METERS, amsl - separation.verticalMeters());
        double high = Math.min(Altitude.HIGHEST_PLANNED_METERS, amsl + separation.verticalMeters());
        Set<DroneId> bound = crafts.stream()
                .filter(craft -> Geodesy.distanceMeters(craft.start().place().point(), place.point())
                        > radius + AT_THE_RIM_METERS)
                .map(Craft::id)
                .collect(Collectors.toSet());
        return new Barrier(
                drone.name() + ", which stands in the air there,",
                new FenceArea.Circle(false, place.point(), radius),
                new AltitudeBand(low, high, Altitude.Reference.AMSL),
                bound);
    }

    /** What could not be served because of one that is gone by now is planned anew. */
    static void observe(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        if (!drone.flags().triggers().contains(LED_ROUND) || stands(drone, look)) {
            return;
        }
        note(draft, drone, false);
        boolean waits = draft.targets().stream()
                .anyMatch(target -> target.state() == RunWaypoint.State.WAITING && target.leftOut());
        if (waits) {
            draft.addCause(LED_ROUND, drone.id(), drone.name() + " is out of the way.");
        }
    }

    /** One that is not heard stands where it was heard last, unless it had something to fly there. */
    private static boolean stands(RunDrone drone, DroneObservation look) {
        boolean foreign = drone.stage() == RunDroneStage.SUSPENDED || drone.stage() == RunDroneStage.LEFT;
        boolean still = !look.isLive() || look.still().compareTo(STANDS) >= 0;
        return foreign && look.airborne() && still && !look.comesDown() && !look.isOnMission();
    }

    private static void note(RunTransition draft, RunDrone drone, boolean on) {
        List<RunTrigger> told = new ArrayList<>(drone.flags().triggers());
        told.remove(LED_ROUND);
        if (on) {
            told.add(LED_ROUND);
        }
        draft.put(drone.with(drone.flags().triggers(told)));
    }
}
