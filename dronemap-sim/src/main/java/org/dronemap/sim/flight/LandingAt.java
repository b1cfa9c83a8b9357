package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre: flies level to a place and lands there. */
public final class LandingAt implements Manoeuvre {
    private static final double NEAR_METERS = 0.5;

    private final NeuPosition place;
    private final CruiseSpeeds cruise;
    private @Nullable Landing landing;
    private double up = Double.NaN;

    public LandingAt(NeuPosition place, CruiseSpeeds cruise) {
        this.place = place;
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        if (Double.isNaN(up)) {
            up = here.up();
        }
        if (landing == null && here.horizontalDistanceTo(place) < NEAR_METERS) {
            landing = new Landing(craft, cruise);
        }
        return landing == null ? cruise.to(place.withUp(up), Double.NaN) : landing.fly(craft, nowMillis);
    }

    @Override
    public boolean done() {
        return landing != null && landing.done();
    }
}
