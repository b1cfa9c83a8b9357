package org.dronemap.cognitive.operation.recovery;

import org.dronemap.cognitive.operation.recovery.RecoveryInput.Look;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.operation.OperationObservation.ObservedDrone;

/** Reduces what is known of a drone to what matters to a recovery. */
final class RecoveryLooks {
    /** m/s: slower it stands, for those who keep drones apart as well. */
    private static final double STANDS_SPEED = 0.7;

    private RecoveryLooks() {}

    static Look of(ObservedDrone seen) {
        DroneState drone = seen.state();
        return new Look(
                drone.id(),
                seen.control().whyNotHeld(),
                silentSeconds(seen),
                flight(seen),
                place(drone),
                seen.giveWay());
    }

    private static RecoveryInput.Flight flight(ObservedDrone seen) {
        DroneState drone = seen.state();
        Steering steering = drone.capabilities().steering(drone.mode()).orElse(null);
        return new RecoveryInput.Flight(
                Boolean.TRUE.equals(drone.armed()),
                drone.airborne(),
                steering != null && steering.acceptsCommands(),
                steering != null && steering.isSafe(),
                steering == Steering.STICKS,
                stands(seen),
                drone.mode());
    }

    private static boolean stands(ObservedDrone seen) {
        Motion motion = seen.state().motion();
        Double ground = motion == null ? null : motion.groundSpeed();
        Double climb = motion == null ? null : motion.climbRate();
        boolean slow = (ground == null || ground < STANDS_SPEED) && (climb == null || Math.abs(climb) < STANDS_SPEED);
        return slow && seen.still().toMillis() > 0;
    }

    private static RecoveryInput.Place place(DroneState drone) {
        Position position = drone.position();
        Home home = drone.home();
        Battery battery = drone.battery();
        ReturnHeight height = drone.returnHeight();
        return new RecoveryInput.Place(
                position == null ? null : position.point(),
                position == null ? null : position.altitudeAboveHomeMeters(),
                home == null ? null : home.point(),
                home == null ? null : (Double) home.altitudeAmslMeters(),
                battery == null ? null : battery.percent(),
                height == null ? null : (Double) height.meters(),
                height == null ? null : (Double) height.beforeMeters());
    }

    /** Not zero either while a vehicle has not said how it is since the process began. */
    private static int silentSeconds(ObservedDrone seen) {
        DroneState drone = seen.state();
        boolean unknown = drone.link().state() == LinkState.LOST
                || drone.mode() == null
                || drone.armed() == null
                || (drone.phase() == null && drone.position() == null);
        return Math.max(unknown ? 1 : 0, (int) seen.silence().toSeconds());
    }
}
