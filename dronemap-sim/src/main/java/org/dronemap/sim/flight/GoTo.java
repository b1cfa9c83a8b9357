package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Position;
import org.dronemap.sim.physics.Setpoint;

/** Flies to a place, nose ahead while it is far, and stays there. */
public final class GoTo implements Manoeuvre {
    private static final double REACHED_METERS = 1.0;
    private static final double NOSE_AHEAD_METERS = 3.0;

    private final Position target;
    private final Cruise cruise;
    private final double fixedYaw;
    private boolean done;

    /** {@code fixedYaw} in radians, NaN: nose ahead. */
    public GoTo(Position target, Cruise cruise, double fixedYaw) {
        this.target = target;
        this.cruise = cruise;
        this.fixedYaw = fixedYaw;
    }

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        Position here = craft.body().position();
        done = here.distanceTo(target) < REACHED_METERS;
        double yaw = fixedYaw;
        if (Double.isNaN(yaw) && here.horizontalDistanceTo(target) > NOSE_AHEAD_METERS) {
            yaw = here.bearingTo(target);
        }
        return cruise.to(target, yaw);
    }

    @Override
    public boolean done() {
        return done;
    }

    public Position target() {
        return target;
    }
}
