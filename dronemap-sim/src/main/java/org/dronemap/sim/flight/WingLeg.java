package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre of an aeroplane: along a line to a waypoint, which is reached near it or abeam of it. */
public final class WingLeg implements Manoeuvre {
    private final NeuPosition from;
    private final NeuPosition to;
    private final double acceptance;
    private final boolean keepsLine;
    private final WingGuidance guidance;
    private boolean done;
    private double distance;

    /**
     * {@code acceptance}: metres from the waypoint at which the next leg begins; {@code keepsLine}: it comes back to the
     * line between the two, instead of always heading for the waypoint.
     */
    public WingLeg(NeuPosition from, NeuPosition to, double acceptance, boolean keepsLine, CruiseSpeeds cruise) {
        this.keepsLine = keepsLine;
        this.from = from;
        this.to = to;
        this.acceptance = acceptance;
        this.guidance = new WingGuidance(cruise);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        distance = here.horizontalDistanceTo(to);
        done = distance <= acceptance || isPast(here);
        return guidance.along(craft.body(), keepsLine ? from : here, to, to.up());
    }

    private boolean isPast(NeuPosition here) {
        double line = from.bearingTo(to);
        return (here.north() - to.north()) * Math.cos(line) + (here.east() - to.east()) * Math.sin(line) >= 0;
    }

    @Override
    public boolean done() {
        return done;
    }

    /** True when it was reached by coming near, false when it was flown past. */
    public boolean near() {
        return distance <= acceptance;
    }

    /** Metres from the waypoint. */
    public double distance() {
        return distance;
    }

    public NeuPosition to() {
        return to;
    }
}
