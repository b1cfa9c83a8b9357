package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;

/** Motors at idle: stays on the ground. */
public final class Grounded implements Manoeuvre {
    private static final MotionSetpoint STILL = new MotionSetpoint.Still();

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        return STILL;
    }
}
