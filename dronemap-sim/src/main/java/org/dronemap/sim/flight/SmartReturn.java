package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre of a multicopter: flies back the way it came, and lands where it took off. */
public final class SmartReturn implements Manoeuvre {
    /** It straightens its way before it sets off. */
    private static final long STRAIGHTENING_MILLIS = 3_500;

    private static final double CORNER_METERS = 2;
    private static final double ABOVE_METERS = 2;
    private static final double NEAR_METERS = 0.3;

    private final ReturnPath path;
    private final CruiseSpeeds cruise;
    private final Hover waiting;
    private long begunAt = -1;
    private @Nullable NeuPosition corner;
    private @Nullable Landing landing;

    public SmartReturn(SimulatedCraft craft, ReturnPath path, CruiseSpeeds cruise) {
        this.path = path;
        this.cruise = cruise;
        this.waiting = new Hover(craft, cruise);
        path.setFlownBack(true);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (landing != null) {
            return landing.fly(craft, nowMillis);
        }
        if (begunAt < 0) {
            begunAt = nowMillis;
        }
        if (nowMillis - begunAt < STRAIGHTENING_MILLIS) {
            return waiting.fly(craft, nowMillis);
        }
        NeuPosition here = craft.body().position();
        boolean last = path.isEmpty();
        if (corner == null || (!last && here.distanceTo(corner) < CORNER_METERS)) {
            corner = nextCorner(here);
        } else if (last && here.distanceTo(corner) < NEAR_METERS) {
            landing = new Landing(craft, cruise);
        }
        return cruise.to(corner, Double.NaN);
    }

    private NeuPosition nextCorner(NeuPosition here) {
        NeuPosition next = path.next();
        NeuPosition chosen = next == null ? here : next;
        return path.isEmpty() ? chosen.withUp(chosen.up() + ABOVE_METERS) : chosen;
    }

    /** Another mode is chosen: the corner that it was on its way to is still ahead of it. */
    public void leave() {
        if (corner != null && landing == null && !path.isEmpty()) {
            path.putBack(corner);
        }
        path.setFlownBack(false);
    }

    @Override
    public boolean done() {
        return landing != null && landing.done();
    }

    /** True while it is on its last way down. */
    public boolean landing() {
        return landing != null;
    }
}
