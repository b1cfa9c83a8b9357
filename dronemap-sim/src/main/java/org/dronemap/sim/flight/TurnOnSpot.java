package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: holds the position and turns by an angle at a rate; radians, clockwise positive. */
public final class TurnOnSpot implements Manoeuvre {
    private static final double REACHED_RADIANS = Math.toRadians(0.5);

    private final NeuPosition place;
    private final CruiseSpeeds cruise;
    private final double from;
    private final double angle;
    private final double rate;
    private long begunAt = -1;
    private boolean done;

    /** {@code rate} in radians a second, above 0. */
    public TurnOnSpot(SimulatedCraft craft, CruiseSpeeds cruise, double angle, double rate) {
        this.place = craft.body().stoppingPoint();
        this.cruise = cruise;
        this.from = craft.body().yaw();
        this.angle = angle;
        this.rate = rate;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begunAt < 0) {
            begunAt = nowMillis;
        }
        double turned = Math.min(Math.abs(angle), rate * (nowMillis - begunAt) / 1000);
        double yaw = from + Math.copySign(turned, angle);
        double left = Math.IEEEremainder(from + angle - craft.body().yaw(), 2 * Math.PI);
        done = turned >= Math.abs(angle) && Math.abs(left) < REACHED_RADIANS;
        return cruise.to(place, yaw);
    }

    @Override
    public boolean done() {
        return done;
    }
}
