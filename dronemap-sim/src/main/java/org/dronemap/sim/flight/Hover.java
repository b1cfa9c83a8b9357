package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: brakes and holds the position, or stays on the ground. */
public final class Hover implements Manoeuvre {
    private final CruiseSpeeds cruise;
    private final boolean grounded;
    private final NeuPosition place;

    public Hover(SimulatedCraft craft, CruiseSpeeds cruise) {
        this.cruise = cruise;
        this.grounded = craft.body().onGround();
        this.place = craft.body().stoppingPoint();
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        return grounded ? new MotionSetpoint.Still() : cruise.to(place, Double.NaN);
    }
}
