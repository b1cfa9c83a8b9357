package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.jspecify.annotations.Nullable;

/** Decides when a drone of a mission run is back that neither lands nor disarms itself: one that drives, or a plane. */
final class HomeArrival {
    private static final double AT_HOME_METERS = 15;
    /** Wider than planes circle. */
    private static final double CIRCLES_METERS = 250;

    private static final Duration STANDS = Duration.ofSeconds(2);

    private HomeArrival() {}

    static boolean isAtHome(RunDrone drone, DroneObservation look) {
        return isWithin(drone, look, AT_HOME_METERS);
    }

    private static boolean isWithin(RunDrone drone, DroneObservation look, double meters) {
        Place place = look.place();
        return place != null
                && Geodesy.distanceMeters(
                                place.point(), drone.craft().finish().place().point())
                        < meters;
    }

    /** One that drives has done all that it was to do, whatever mode it stops in at the end. */
    static boolean isDriven(RunDrone drone, DroneObservation look) {
        boolean done = !drone.profile().flies()
                && drone.stage() == RunDroneStage.FLYING
                && drone.orders().isEmpty()
                && drone.next() == null;
        // Vehicles stop a moment before they say that their mission is complete.
        return done && (look.isAtTheEnd() || (!look.isOnMission() && isAtHome(drone, look)));
    }

    /** One that drives, and was called. */
    static boolean standsAtHome(RunDrone drone, DroneObservation look) {
        return !drone.profile().flies() && isAtHome(drone, look) && look.still().compareTo(STANDS) >= 0;
    }

    /** Ends the part of one that stands at the end of its way; a boat stays armed, else it would drift away. */
    static void end(RunTransition draft, RunDrone drone) {
        if (drone.profile().kind() == VehicleKind.ROVER) {
            draft.sendCommand(drone, IssuedCommand.Purpose.DISARM, new Command.Disarm(false));
        } else {
            boolean called = drone.stage() == RunDroneStage.RETURNING && !draft.stopping();
            draft.put(drone.withSortie(null, 0)
                    .noted(drone.name() + " holds its place at home, armed.")
                    .to(called ? RunDroneStage.LEFT : RunDroneStage.LANDED, draft.now()));
        }
    }

    /** True: a plane with nothing left to fly has just been found to circle over its home, which it does until it is landed. */
    static boolean circles(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean circles = drone.profile().kind() == VehicleKind.FIXED_WING
                && drone.orders().isEmpty()
                && look.isArmed()
                && look.comesDown()
                && isWithin(drone, look, CIRCLES_METERS);
        if (circles) {
            String words = drone.name() + " circles over its home, since no run lands it. Nobody controls it now:"
                    + " take control of it and land it.";
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.LEFT, RunTrigger.WENT_HOME, words);
        }
        return circles;
    }

    /** What is still under way at its home at the end, as a sentence; null: nothing is. */
    static @Nullable String leftoverNotice(RunDrone drone) {
        String note = drone.note();
        boolean stays = note != null
                && (note.endsWith(" holds its place at home, armed.") || note.contains(" circles over its home, "));
        return stays ? note : null;
    }
}
