package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.sim.physics.MotionSetpoint;

/** Makes the simulated ArduPlane run along and climb out: full power, straight ahead. */
final class ClimbOut {
    /** Metres a second, as of the aeroplane that was recorded. */
    static final double RATE = 9.4;

    private static final double SPEED = 28;

    private ClimbOut() {}

    static MotionSetpoint setpoint() {
        return new MotionSetpoint.Wing(0, SPEED, RATE, true);
    }
}
