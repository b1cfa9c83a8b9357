package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;

/** Simulated manoeuvre: brakes until it stands, with the motors on; there is no way to go. */
public final class Braking implements Manoeuvre {
    private static final MotionSetpoint STOP = new MotionSetpoint.Velocity(0, 0, 0, Double.NaN);

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        return STOP;
    }

    @Override
    public boolean done() {
        return true;
    }
}
