package org.dronemap.core.separation;

import org.dronemap.core.drone.Identification;

/**
 * Speeds and acceleration of a drone on its ways, in m/s and m/s²; what is not known of a vehicle is assumed for its kind.
 *
 * @param cruise over the ground
 * @param acceleration gathering speed and braking; infinite: at once
 */
public record FlightPace(double cruise, double climb, double descent, double acceleration) {
    private static final double FASTEST = 60;

    public FlightPace {
        if (!(cruise > 0 && climb > 0 && descent > 0 && acceleration > 0)) {
            throw new IllegalArgumentException("speeds are above 0: " + cruise + ", " + climb + ", " + descent);
        }
    }

    /** As vehicles of that kind are delivered with such an autopilot. */
    public static FlightPace of(Identification vehicle) {
        return switch (vehicle.kind()) {
            case MULTICOPTER, HELICOPTER, UNKNOWN -> ofCopter(vehicle.autopilot());
            case FIXED_WING, VTOL -> new FlightPace(16, 3, 2, 3);
            case AIRSHIP -> new FlightPace(5, 1, 1, 0.5);
            case ROVER, BOAT, SUBMARINE -> new FlightPace(1.5, 1, 1, 0.5);
        };
    }

    /** ArduCopter's WPNAV_SPEED, WPNAV_SPEED_UP, WPNAV_SPEED_DN and WPNAV_ACCEL; PX4's MPC_XY_CRUISE and MPC_Z_V_AUTO_*. */
    private static FlightPace ofCopter(String autopilot) {
        return switch (autopilot) {
            case "ArduPilot" -> new FlightPace(10, 2.5, 1.5, 2.5);
            case "PX4" -> new FlightPace(5, 3, 1.5, 3);
            default -> new FlightPace(8, 2.5, 1.5, 2.5);
        };
    }

    /** At least as fast as it was seen. */
    public FlightPace atLeast(double metersPerSecond) {
        return metersPerSecond > cruise
                ? new FlightPace(Math.min(metersPerSecond, FASTEST), climb, descent, acceleration)
                : this;
    }
}
