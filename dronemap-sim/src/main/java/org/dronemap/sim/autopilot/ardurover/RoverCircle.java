package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/**
 * Simulated manoeuvre of a ground vehicle: drives to the edge of a circle, ever more slowly, and so many turns around its
 * middle.
 */
final class RoverCircle implements Manoeuvre {
    private static final double AT_EDGE_METERS = 0.9;
    private static final double SLOWING_GAIN = 0.19;
    private static final double ACCELERATION = 0.4;
    private static final double INWARDS_GAIN = 0.5;

    private final NeuPosition centre;
    private final double radius;
    private final double side;
    private final double turns;
    private final CruiseSpeeds cruise;
    private boolean circling;
    private double speed;
    private double angle;
    private long lastMillis;

    /** {@code radius} in metres, below 0 to the left. */
    RoverCircle(NeuPosition centre, double radius, double turns, CruiseSpeeds cruise) {
        this.centre = centre;
        this.radius = Math.abs(radius);
        this.side = Math.signum(radius);
        this.turns = turns;
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        double outside = here.horizontalDistanceTo(centre) - radius;
        double bearing = centre.bearingTo(here);
        if (!circling && Math.abs(outside) > AT_EDGE_METERS) {
            double slow = Math.min(cruise.horizontal(), SLOWING_GAIN * Math.abs(outside));
            return towards(outside > 0 ? bearing + Math.PI : bearing, slow);
        }
        if (!circling) {
            circling = true;
            lastMillis = nowMillis;
        }
        double seconds = (nowMillis - lastMillis) / 1000.0;
        lastMillis = nowMillis;
        speed = Math.min(cruise.horizontal(), speed + ACCELERATION * seconds);
        angle += speed / radius * seconds;
        double inwards = Math.atan(INWARDS_GAIN * outside);
        return towards(bearing + side * (Math.PI / 2 + inwards), speed);
    }

    private static MotionSetpoint towards(double course, double speed) {
        return new MotionSetpoint.Velocity(speed * Math.cos(course), speed * Math.sin(course), 0, Double.NaN);
    }

    @Override
    public boolean done() {
        return circling && angle >= turns * 2 * Math.PI;
    }
}
