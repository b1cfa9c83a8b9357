package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** A take-off of a simulated QuadPlane on its lift motors: straight up, and there it stays. */
final class LiftClimb implements Manoeuvre {
    private static final long SPOOL_MILLIS = 1_100;
    private static final double REACHED_METERS = 0.3;

    private final double up;
    private final CruiseSpeeds speeds;
    private @Nullable NeuPosition place;
    private long begunAt = -1;
    private boolean done;

    /** {@code up} is the height in the vehicle's own frame. */
    LiftClimb(double up, CruiseSpeeds speeds) {
        this.up = up;
        this.speeds = speeds;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (!craft.armed()) {
            return new MotionSetpoint.Still();
        }
        if (begunAt < 0) {
            begunAt = nowMillis;
        }
        if (place == null) {
            place = craft.body().position().withUp(up);
        }
        done |= craft.body().up() >= up - REACHED_METERS;
        boolean spools = craft.body().onGround() && nowMillis - begunAt < SPOOL_MILLIS;
        return spools ? new MotionSetpoint.Still() : speeds.to(place, Double.NaN);
    }

    @Override
    public boolean done() {
        return done;
    }
}
