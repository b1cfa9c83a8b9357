package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
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
        Separation separation = draft.setting().rules().separation();
        for (DroneObservation look : looks) {
            RunDrone drone = draft.drone(look.drone());
            String words = drone.name() + ", which stands in the air there,";
            List<SilentPlaces.Piece> pieces = List.of();
            RunDrone.LinkLoss loss = drone.flags().linkLoss();
            Place place = look.place();
            if (loss != null && loss.place() != null && mayHoverUnheard(draft, drone, look)) {
                words = drone.name() + ", which was last heard there and may still be there until "
                        + SilentPlaces.until(drone, loss) + ",";
                pieces = SilentPlaces.of(drone, loss, loss.place());
            } else if (place != null && stands(draft, drone, look)) {
                pieces = List.of(new SilentPlaces.Piece(place, place));
            }
            List<Barrier> own = new ArrayList<>();
            for (SilentPlaces.Piece there : pieces) {
                own.add(barrier(words, there, separation, crafts));
            }
            own.removeIf(barrier -> barrier.drones().isEmpty());
            barriers.addAll(own);
            if (!own.isEmpty()) {
                note(draft, drone, true);
            }
        }
        return barriers;
    }

    private static Barrier barrier(
            String words, SilentPlaces.Piece there, Separation separation, Collection<Craft> crafts) {
        double radius = separation.horizontalMeters() + ROOM_METERS;
        double low = Math.max(Altitude.LOWEST_PLANNED_METERS, there.low() - separation.verticalMeters());
        double high = Math.min(Altitude.HIGHEST_PLANNED_METERS, there.high() + separation.verticalMeters());
        // Whoever sets off or lands nearer cannot be led round it, and is kept apart in flight.
        Set<DroneId> bound = crafts.stream()
                .filter(craft -> Stream.of(craft.start().place(), craft.finish().place())
                        .allMatch(place -> there.distanceMeters(place) > radius + AT_THE_RIM_METERS))
                .map(Craft::id)
                .collect(Collectors.toSet());
        return new Barrier(words, there.around(radius), new AltitudeBand(low, high, Altitude.Reference.AMSL), bound);
    }

    /** One that is not heard, and may have come to stand where nobody sees it. */
    private static boolean mayHoverUnheard(RunTransition draft, RunDrone drone, DroneObservation look) {
        return !draft.isWordedBefore(2) && SilentPlaces.mayHover(drone, look, draft.now());
    }

    /** What could not be served because of one that is gone by now is planned anew. */
    static void observe(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        if (!drone.flags().triggers().contains(LED_ROUND)
                || stands(draft, drone, look)
                || mayHoverUnheard(draft, drone, look)
                || isAboutToReport(drone, look)) {
            return;
        }
        note(draft, drone, false);
        boolean waits = draft.targets().stream()
                .anyMatch(target -> target.state() == RunWaypoint.State.WAITING && target.leftOut());
        // For one that is led again there is a plan anyway.
        if (waits && (draft.isWordedBefore(2) || !drone.stage().acceptsCommands())) {
            boolean unheard = !draft.isWordedBefore(2) && drone.stage() == RunDroneStage.GONE && !look.isLive();
            String words = unheard
                    ? "The place where " + drone.name() + " was last heard is free."
                    : drone.name() + " is out of the way.";
            draft.addCause(LED_ROUND, drone.id(), words);
        }
    }

    /** What becomes of it is decided first: it may stand there still. */
    private static boolean isAboutToReport(RunDrone drone, DroneObservation look) {
        return look.isLive() && drone.stage() == RunDroneStage.SILENT;
    }

    /** A waypoint waits for a place to be free, and there is who can serve it then. */
    static boolean isWaitedFor(RunTransition draft) {
        return draft.drones().stream().anyMatch(drone -> drone.stage().acceptsCommands())
                && draft.drones().stream()
                        .anyMatch(drone -> drone.stage() == RunDroneStage.GONE
                                && drone.flags().triggers().contains(LED_ROUND));
    }

    /** One that is not heard stands where it was heard last, unless it had something to fly there. */
    private static boolean stands(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean heardAgain =
                drone.stage() == RunDroneStage.GONE && look.isLive() && look.waits() && !draft.isWordedBefore(2);
        boolean foreign = drone.stage() == RunDroneStage.SUSPENDED || drone.stage() == RunDroneStage.LEFT || heardAgain;
        boolean still = !look.isLive() || heardAgain || look.still().compareTo(STANDS) >= 0;
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
