package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;

/** Steers a simulated aeroplane along a line or around a place, and to a height. */
public final class WingGuidance {
    /** Metres over which it comes back to its line, or turns towards it. */
    private static final double REACH_METERS = 82;

    private static final double HEIGHT_SECONDS = 4;
    private static final double CIRCLE_GAIN = 1.5;
    /** Within so many radii it begins to bend into the circle; before, it heads for its middle. */
    private static final double BEND_RADII = 1.72;

    private static final double NEAR_RADII = 1.5;

    private final CruiseSpeeds cruise;

    public WingGuidance(CruiseSpeeds cruise) {
        this.cruise = cruise;
    }

    /** Along the line from one place to another, and on beyond it. */
    public MotionSetpoint.Wing along(VehicleBody body, NeuPosition from, NeuPosition to, double up) {
        double line = from.bearingTo(to);
        double beside = besideMeters(body.position(), from, line);
        double back = Math.asin(Math.max(-0.7, Math.min(0.7, beside / REACH_METERS)));
        return bent(body, towards(body, line - back), up);
    }

    private static double besideMeters(NeuPosition here, NeuPosition from, double line) {
        return (here.east() - from.east()) * Math.cos(line) - (here.north() - from.north()) * Math.sin(line);
    }

    /** To a circle around a place and on around it, to the right, or to the left with a radius below 0. */
    public MotionSetpoint.Wing around(VehicleBody body, NeuPosition centre, double radius, double up) {
        NeuPosition here = body.position();
        double size = Math.abs(radius);
        double away = centre.horizontalDistanceTo(here);
        double inwards = away > size * BEND_RADII ? Math.PI / 2 : Math.atan(CIRCLE_GAIN * (away - size) / size);
        double side = Math.signum(radius);
        double course = centre.bearingTo(here) + side * (Math.PI / 2 + inwards);
        boolean near = away < size * NEAR_RADII;
        double centripetal = near ? side * body.groundSpeed() * body.groundSpeed() / size : 0;
        return bent(body, towards(body, course) + centripetal, up);
    }

    /** Straight on as it flies. */
    public MotionSetpoint.Wing straight(VehicleBody body, double up) {
        return bent(body, 0, up);
    }

    private MotionSetpoint.Wing bent(VehicleBody body, double lateral, double up) {
        return new MotionSetpoint.Wing(lateral, cruise.horizontal(), climb(body, up), false);
    }

    private double climb(VehicleBody body, double up) {
        MotionSetpoint.Reach limits = cruise.to(body.position(), Double.NaN);
        double wanted = (up - body.up()) / HEIGHT_SECONDS;
        return Math.max(-limits.sinkSpeed(), Math.min(limits.climbSpeed(), wanted));
    }

    /** The acceleration to the right that turns its course to that one. */
    private static double towards(VehicleBody body, double course) {
        double track = Math.atan2(body.velocityEast(), body.velocityNorth());
        double error = Math.IEEEremainder(course - track, 2 * Math.PI);
        double angle = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, error));
        return 2 * body.groundSpeed() * body.groundSpeed() / REACH_METERS * Math.sin(angle);
    }
}
