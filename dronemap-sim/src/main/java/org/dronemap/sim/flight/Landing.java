package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: lands where the vehicle is. */
public final class Landing implements Manoeuvre {
    private final CruiseSpeeds cruise;
    private final NeuPosition place;
    private boolean done;

    public Landing(SimulatedCraft craft, CruiseSpeeds cruise) {
        this.cruise = cruise;
        this.place = craft.body().stoppingPoint();
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        done = craft.landed();
        return craft.body().onGround()
                ? new MotionSetpoint.Still()
                : cruise.downAt(place, craft.body().up());
    }

    @Override
    public boolean done() {
        return done;
    }
}
