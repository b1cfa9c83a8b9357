package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;

/** Simulated manoeuvre of an aeroplane: flies to a place and circles around it. */
public final class Circle implements Manoeuvre {
    /** It begins to turn at so many radii; its circle then is a quarter wider than asked for, as of a real one. */
    private static final double CAPTURE_RADII = 2.15;

    private static final double WIDER = 1.25;
    private static final double AT_HEIGHT_METERS = 1;

    private final NeuPosition centre;
    private final double radius;
    private final WingGuidance guidance;
    private boolean reached;
    private boolean atHeight;
    private double turned;
    private double lastBearing = Double.NaN;

    /** {@code radius} in metres, below 0 to the left; {@code centre} has the height. */
    public Circle(NeuPosition centre, double radius, CruiseSpeeds cruise) {
        this.centre = centre;
        this.radius = radius;
        this.guidance = new WingGuidance(cruise);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        VehicleBody body = craft.body();
        NeuPosition here = body.position();
        reached |= here.horizontalDistanceTo(centre) <= Math.abs(radius) * CAPTURE_RADII;
        atHeight |= Math.abs(here.up() - centre.up()) < AT_HEIGHT_METERS;
        if (reached) {
            count(centre.bearingTo(here));
        }
        return guidance.around(body, centre, radius * WIDER, centre.up());
    }

    private void count(double bearing) {
        if (!Double.isNaN(lastBearing)) {
            turned += Math.IEEEremainder(bearing - lastBearing, 2 * Math.PI) * Math.signum(radius);
        }
        lastBearing = bearing;
    }

    /** It has come to its circle. */
    public boolean reached() {
        return reached;
    }

    /** It has been at its height. */
    public boolean atHeight() {
        return atHeight;
    }

    /** Turns around the place since it has come to its circle. */
    public double turns() {
        return turned / (2 * Math.PI);
    }

    public NeuPosition centre() {
        return centre;
    }

    public double radius() {
        return radius;
    }

    /** A circle never ends by itself. */
    @Override
    public boolean done() {
        return false;
    }
}
