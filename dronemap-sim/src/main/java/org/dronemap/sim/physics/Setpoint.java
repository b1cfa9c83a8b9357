package org.dronemap.sim.physics;

/** A setpoint for the motors until the next step. */
public sealed interface Setpoint {
    /** Motors stopped: stands on the ground, or falls. */
    record Still() implements Setpoint {}

    /** Fly to a place and stay there; speeds in m/s, yaw in radians, NaN keeps the present yaw. */
    record Reach(Position target, double horizontalSpeed, double climbSpeed, double sinkSpeed, double yaw)
            implements Setpoint {
        public Reach slowerThan(double metersPerSecond) {
            return new Reach(target, Math.min(horizontalSpeed, metersPerSecond), climbSpeed, sinkSpeed, yaw);
        }
    }

    /** Fly with a velocity in m/s. */
    record Velocity(double north, double east, double up, double yaw) implements Setpoint {}

    /** Be at a place that moves with a velocity in m/s, and come up to it with the speeds of {@code place}. */
    record Chase(Reach place, double north, double east, double up) implements Setpoint {}
}
