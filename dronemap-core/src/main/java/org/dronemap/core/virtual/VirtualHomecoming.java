package org.dronemap.core.virtual;

import java.time.Duration;
import java.util.Optional;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;

/**
 * Rules by which a virtual drone's drone is back that neither lands nor disarms itself: one that drives stands at home, a
 * plane circles there.
 */
final class VirtualHomecoming {
    private static final double AT_HOME_METERS = 15;
    /** Wider than planes circle. */
    private static final double CIRCLES_METERS = 250;

    private static final Duration STANDS = Duration.ofSeconds(2);

    private VirtualHomecoming() {}

    /** It goes along the ground, is where it began, and has come to a stop. */
    static boolean standsAtHome(DroneState drone, VirtualRunObservation sight) {
        return drone.identification().kind().neverFlies()
                && isWithin(drone, AT_HOME_METERS)
                && sight.still().compareTo(STANDS) >= 0;
    }

    /** What follows of one that stands at home, as a sentence; empty: it is disarmed there. A boat would drift away. */
    static Optional<String> whyStaysArmed(DroneState drone) {
        return drone.identification().kind() == VehicleKind.ROVER
                ? Optional.empty()
                : Optional.of("The drone holds its place at home, armed. Nobody controls it now.");
    }

    /** A plane that went home and flies round there until somebody lands it, as a sentence. */
    static Optional<String> circling(DroneState drone) {
        boolean circles = drone.identification().kind() == VehicleKind.FIXED_WING
                && drone.capabilities().isSafe(drone.mode())
                && isWithin(drone, CIRCLES_METERS);
        return circles
                ? Optional.of("The drone circles over its home, since no mission of a virtual drone lands it. Nobody"
                        + " controls it now: take control of it and land it.")
                : Optional.empty();
    }

    /** Of one that is disarmed before all is flown, as a sentence. */
    static String endedEarly(DroneState drone) {
        return drone.identification().kind().neverFlies()
                ? "The drone was disarmed before the end."
                : "The drone came down before the end.";
    }

    private static boolean isWithin(DroneState drone, double meters) {
        Position position = drone.position();
        Home home = drone.home();
        return position != null
                && position.point() != null
                && home != null
                && Geodesy.distanceMeters(position.point(), home.point()) < meters;
    }
}
