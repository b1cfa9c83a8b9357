package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre of a multicopter: flies to the edge of a circle and so many turns around its middle. */
public final class CircleTurns implements Manoeuvre {
    private static final double AT_EDGE_METERS = 3;
    private static final double ACCELERATION = 2.5;
    private static final double SHARE_FOR_TURNING = 0.5;
    private static final double SLOW = 0.5;

    private final NeuPosition centre;
    private final double radius;
    private final double turns;
    private final double rate;
    private final CruiseSpeeds cruise;
    private @Nullable GoTo wayToEdge;
    private boolean circling;
    private double bearing;
    private double angle;
    private double speed;
    private long lastMillis = -1;

    /** {@code radius} in metres, {@code rate} in radians a second, to the left below 0; {@code centre} has the height. */
    public CircleTurns(NeuPosition centre, double radius, double turns, double rate, CruiseSpeeds cruise) {
        this.centre = centre;
        this.radius = radius;
        this.turns = turns;
        this.rate = rate;
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        if (!circling) {
            MotionSetpoint onTheWay = approach(craft, nowMillis);
            if (onTheWay != null) {
                return onTheWay;
            }
            circling = true;
            bearing = centre.bearingTo(here);
            lastMillis = nowMillis;
        }
        double seconds = (nowMillis - lastMillis) / 1000.0;
        lastMillis = nowMillis;
        double most = Math.min(Math.abs(rate), Math.sqrt(SHARE_FOR_TURNING * ACCELERATION * radius) / radius);
        speed = Math.min(most, speed + most * seconds);
        double side = Math.signum(rate);
        angle += speed * seconds;
        bearing += side * speed * seconds;
        NeuPosition target = edge(bearing);
        double along = bearing + side * Math.PI / 2;
        return new MotionSetpoint.Track(
                cruise.to(target, here.bearingTo(centre)),
                speed * radius * Math.cos(along),
                speed * radius * Math.sin(along),
                0);
    }

    /** Null when it is at the edge. */
    private @Nullable MotionSetpoint approach(SimulatedCraft craft, long nowMillis) {
        GoTo way = wayToEdge;
        if (way == null) {
            NeuPosition edge = edge(centre.bearingTo(craft.body().stoppingPoint()));
            if (craft.body().position().distanceTo(edge) <= AT_EDGE_METERS) {
                return null;
            }
            way = GoTo.leg(edge, cruise, Double.NaN);
            wayToEdge = way;
        }
        MotionSetpoint setpoint = way.fly(craft, nowMillis);
        return way.done() && craft.body().groundSpeed() < SLOW ? null : setpoint;
    }

    private NeuPosition edge(double direction) {
        return new NeuPosition(
                centre.north() + radius * Math.cos(direction),
                centre.east() + radius * Math.sin(direction),
                centre.up());
    }

    @Override
    public boolean done() {
        return circling && angle >= turns * 2 * Math.PI;
    }
}
