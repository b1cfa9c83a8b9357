package org.dronemap.sim.physics;

/** Motion that a simulated vehicle's motors shall bring about in the next physics step. */
public sealed interface MotionSetpoint {
    /** Motors stopped: stands on the ground, or falls. */
    record Still() implements MotionSetpoint {}

    /** Fly to a place and stay there; speeds in m/s, yaw in radians, NaN keeps the present yaw. */
    record Reach(NeuPosition target, double horizontalSpeed, double climbSpeed, double sinkSpeed, double yaw)
            implements MotionSetpoint {
        public Reach slowerThan(double metersPerSecond) {
            return new Reach(target, Math.min(horizontalSpeed, metersPerSecond), climbSpeed, sinkSpeed, yaw);
        }
    }

    /** Fly with a velocity in m/s. */
    record Velocity(double north, double east, double up, double yaw) implements MotionSetpoint {}

    /** Be at a place that moves with a velocity in m/s, and come up to it with the speeds of {@code place}. */
    record Track(Reach place, double north, double east, double up) implements MotionSetpoint {}

    /**
     * Fly on wings: bend the path by so many m/s² to the right, with an airspeed in m/s, rising by so many m/s; a
     * {@code run} is the way along the runway before and during a take-off, with full power.
     */
    record Wing(double lateral, double airspeed, double climb, boolean run) implements MotionSetpoint {}

    /** Glide with the wings level and no power, or roll out on the ground. */
    record Glide() implements MotionSetpoint {}
}
