package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/**
 * Simulated manoeuvre: drives to a place and stands there. Reached is also what it has driven past: what steers with its
 * wheels cannot turn back on the spot.
 */
public final class DriveTo implements Manoeuvre {
    private static final MotionSetpoint STOP = new MotionSetpoint.Velocity(0, 0, 0, Double.NaN);
    private static final double CORNER_SPEED = 2;
    private static final double DECELERATION = 0.65;
    private static final double ARRIVED_METERS = 0.3;
    /** The shortest way takes it as long, as seen on a real one. */
    private static final long LEAST_MILLIS = 1_300;

    private final NeuPosition from;
    private final NeuPosition target;
    private final CruiseSpeeds cruise;
    private final double radius;
    private final boolean stops;
    private boolean there;
    private boolean done;
    private long begunAt = -1;

    /** Stands at {@code target}; {@code radius} in metres around it counts as reached. */
    public DriveTo(SimulatedCraft craft, NeuPosition target, CruiseSpeeds cruise, double radius) {
        this(craft, target, cruise, radius, true);
    }

    private DriveTo(SimulatedCraft craft, NeuPosition target, CruiseSpeeds cruise, double radius, boolean stops) {
        this.from = craft.body().position();
        this.target = target;
        this.cruise = cruise;
        this.radius = radius;
        this.stops = stops;
    }

    /** Drives past {@code target} as slowly as it takes corners. */
    public static DriveTo through(SimulatedCraft craft, NeuPosition target, CruiseSpeeds cruise, double radius) {
        return new DriveTo(craft, target, cruise, radius, false);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        double distance = here.horizontalDistanceTo(target);
        if (begunAt < 0) {
            begunAt = nowMillis;
        }
        there = there || distance < (stops ? ARRIVED_METERS : radius) || (isPast(here) && distance < radius);
        done = there && (!stops || nowMillis - begunAt >= LEAST_MILLIS);
        if (stops) {
            return there ? STOP : cruise.to(target, Double.NaN);
        }
        double slowing = Math.sqrt(CORNER_SPEED * CORNER_SPEED + 2 * DECELERATION * Math.max(0, distance - radius));
        double speed = Math.min(cruise.horizontal(), slowing);
        double bearing = here.bearingTo(target);
        return new MotionSetpoint.Velocity(speed * Math.cos(bearing), speed * Math.sin(bearing), 0, Double.NaN);
    }

    /** Beyond the line through the target that stands across the way from its start. */
    private boolean isPast(NeuPosition here) {
        double wayNorth = target.north() - from.north();
        double wayEast = target.east() - from.east();
        return (here.north() - target.north()) * wayNorth + (here.east() - target.east()) * wayEast > 0;
    }

    @Override
    public boolean done() {
        return done;
    }

    public NeuPosition target() {
        return target;
    }
}
