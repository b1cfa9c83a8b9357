package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Describes a mission run's drones to the planner as they are now, for a re-planning. */
final class CraftSnapshots {
    /** Who hovers goes on when its new mission is on board. */
    private static final double UNTIL_ON_BOARD_SECONDS = 2;

    private static final double LOW_METERS = 3;
    /** By its speed; it slows down at the top, and takes a second more. */
    private static final double NEARLY_UP_SECONDS = 1;
    /** What its way home may take of what the straight one does, as it waits for others and goes round fences. */
    private static final double HOMEWARD = 1.2;

    private CraftSnapshots() {}

    /** Whether it can be given something now. */
    static boolean isUsable(RunDrone drone, DroneObservation look) {
        boolean there = !look.isLost()
                && look.ready()
                && look.holder() == null
                && drone.flags().held()
                && look.place() != null;
        return there && drone.stage().acceptsCommands() && !isLanding(drone);
    }

    /** Its last item is its landing, and it is on it. */
    private static boolean isLanding(RunDrone drone) {
        Sortie sortie = drone.sortie();
        return drone.stage() == RunDroneStage.FLYING
                && sortie != null
                && drone.passed() >= sortie.mission().items().size() - 1;
    }

    static Craft now(RunTransition draft, RunDrone drone, DroneObservation look) {
        Place place = Objects.requireNonNull(look.place());
        return drone.craft().with(start(drone, look, place)).with(supply(draft, drone, look));
    }

    private static Start start(RunDrone drone, DroneObservation look, Place place) {
        return switch (drone.stage()) {
            case LANDED, UPLOADING, READY, ARMING -> Start.onGround(place);
            case FLYING, STARTING -> isTakingOff(drone) ? onTop(drone, place) : Start.inFlight(place);
            default ->
                look.airborne() || !drone.profile().flies()
                        ? new Start(place, true, UNTIL_ON_BOARD_SECONDS)
                        : Start.onGround(place);
        };
    }

    /** It climbs straight up, and is left to that. */
    static boolean isTakingOff(RunDrone drone) {
        Sortie sortie = drone.sortie();
        return drone.passed() == 0 && sortie != null && sortie.mission().items().get(0) instanceof MissionItem.TakeOff;
    }

    /** It takes off, and not only for a moment yet: what it gets is brought to it when it is up. */
    static boolean isBusy(RunDrone drone, @Nullable Place place) {
        boolean takesOff = drone.stage().mayFly() && isTakingOff(drone);
        return takesOff && (place == null || climbSeconds(drone, place) > NEARLY_UP_SECONDS);
    }

    /** It climbs straight up first, whatever it does then. */
    private static Start onTop(RunDrone drone, Place place) {
        Place top = top(drone, place);
        double climb = top.altitudeAmslMeters() - place.altitudeAmslMeters();
        return climb < LOW_METERS ? Start.inFlight(place) : new Start(top, true, climbSeconds(drone, place));
    }

    private static double climbSeconds(RunDrone drone, Place place) {
        double climb = top(drone, place).altitudeAmslMeters() - place.altitudeAmslMeters();
        return climb / drone.craft().performance().speeds().climb();
    }

    private static Place top(RunDrone drone, Place place) {
        Sortie sortie = Objects.requireNonNull(drone.sortie());
        List<TimedPlace> fixes = sortie.tour().way(0).fixes();
        return place.at(
                Math.max(place.altitudeAmslMeters(), fixes.get(1).place().altitudeAmslMeters()));
    }

    /** What is left: by its battery's word, else by what it must have drawn. */
    private static EnergyBudget supply(RunTransition draft, RunDrone drone, DroneObservation look) {
        EnergyBudget first = drone.craft().supply();
        if (Double.isInfinite(first.remainingJoules())) {
            return first;
        }
        Double told = FlightHealth.remaining(drone, look);
        Sortie sortie = drone.sortie();
        double flown = sortie == null || drone.stage().compareTo(RunDroneStage.STARTING) < 0
                ? 0
                : Math.max(
                        0, Duration.between(draft.clock().begun(), draft.now()).toMillis() / 1_000.0);
        double drawn = flown * drone.craft().performance().power().cruise();
        double left = told == null ? Math.max(0, first.remainingJoules() - drawn) : told;
        return new EnergyBudget(left, reserve(drone, look, left));
    }

    /** Who is past its reserve in the air is planned home: a plan that leaves nothing else would be none. */
    private static double reserve(RunDrone drone, DroneObservation look, double left) {
        double reserve = drone.craft().supply().reserveJoules();
        Place place = look.place();
        return look.airborne() && place != null
                ? Math.max(0, Math.min(reserve, left - HOMEWARD * FlightHealth.joulesHome(drone, place)))
                : reserve;
    }
}
