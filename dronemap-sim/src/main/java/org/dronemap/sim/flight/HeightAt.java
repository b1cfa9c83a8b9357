package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre of a multicopter: flies to a place, and stays there until it has the place's height. */
public final class HeightAt implements Manoeuvre {
    private static final double THERE_METERS = 2;
    private static final double AT_HEIGHT_METERS = 0.1;

    private final NeuPosition target;
    private final GoTo way;
    private boolean there;
    private boolean done;

    public HeightAt(NeuPosition target, CruiseSpeeds cruise) {
        this.target = target;
        this.way = GoTo.leg(target, cruise, Double.NaN);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        there |= here.horizontalDistanceTo(target) < THERE_METERS;
        done |= there && Math.abs(here.up() - target.up()) < AT_HEIGHT_METERS;
        return way.fly(craft, nowMillis);
    }

    @Override
    public boolean done() {
        return done;
    }
}
