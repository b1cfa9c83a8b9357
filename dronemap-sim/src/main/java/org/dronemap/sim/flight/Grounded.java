package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Setpoint;

/** Motors at idle: stays on the ground. */
public final class Grounded implements Manoeuvre {
    private static final Setpoint STILL = new Setpoint.Still();

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        return STILL;
    }
}
