package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;

/** Simulated manoeuvre: stays on the ground with the motors at idle. */
public final class Grounded implements Manoeuvre {
    private static final MotionSetpoint STILL = new MotionSetpoint.Still();

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        return STILL;
    }
}
