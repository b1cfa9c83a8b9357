package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: spools the motors up and climbs straight to a height in the vehicle's local frame. */
public final class TakeOff implements Manoeuvre {
    private static final long SPOOL_MILLIS = 2_800;
    private static final long LIFTING_MILLIS = 1_900;
    private static final double REACHED_METERS = 0.3;

    private final NeuPosition target;
    private final CruiseSpeeds cruise;
    private long begun = -1;
    private boolean done;

    public TakeOff(SimulatedCraft craft, double up, CruiseSpeeds cruise) {
        this.target = craft.body().position().withUp(up);
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begun < 0) {
            begun = nowMillis;
        }
        if (craft.body().onGround() && nowMillis - begun < SPOOL_MILLIS) {
            if (nowMillis - begun >= LIFTING_MILLIS) {
                craft.liftOff(nowMillis);
            }
            return new MotionSetpoint.Still();
        }
        done = done || craft.body().up() >= target.up() - REACHED_METERS;
        return cruise.to(target, Double.NaN);
    }

    @Override
    public boolean done() {
        return done;
    }
}
