package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.DriveTo;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.ReturnPath;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre of a ground vehicle: drives back the way it came, and stands where it was armed. */
final class RoverSmartReturn implements Manoeuvre {
    /** It straightens its way before it sets off. */
    private static final long STRAIGHTENING_MILLIS = 2_500;

    private static final MotionSetpoint STOP = new MotionSetpoint.Velocity(0, 0, 0, Double.NaN);

    private final ReturnPath path;
    private final CruiseSpeeds cruise;
    private final double radius;
    private @Nullable DriveTo leg;
    private boolean done;
    private long begunAt = -1;

    RoverSmartReturn(ReturnPath path, CruiseSpeeds cruise, double radius) {
        this.path = path;
        this.cruise = cruise;
        this.radius = radius;
        path.setFlownBack(true);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begunAt < 0) {
            begunAt = nowMillis;
            done = !path.leadsAway();
        }
        if (done || nowMillis - begunAt < STRAIGHTENING_MILLIS) {
            return STOP;
        }
        if (leg == null || leg.done()) {
            NeuPosition next = path.next();
            done = next == null;
            if (next != null) {
                leg = path.isEmpty()
                        ? new DriveTo(craft, next, cruise, radius)
                        : DriveTo.through(craft, next, cruise, radius);
            }
        }
        return leg == null ? STOP : leg.fly(craft, nowMillis);
    }

    /** Another mode is chosen: the place that it was on its way to is still ahead of it. */
    void leave() {
        if (leg != null && !leg.done()) {
            path.putBack(leg.target());
        }
        path.setFlownBack(false);
    }

    @Override
    public boolean done() {
        return done;
    }
}
