package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: flies to a place, nose ahead while it is far, and stays there. */
public final class GoTo implements Manoeuvre {
    private static final double EASING_JERK = 1.0;
    private static final double EASING_SECONDS = 2.5;
    private static final double REACHED_METERS = 1.0;
    private static final double LEG_REACHED_METERS = 2.0;
    private static final double NOSE_AHEAD_METERS = 3.0;

    private final NeuPosition target;
    private final CruiseSpeeds cruise;
    private final double fixedYaw;
    private final boolean easing;
    private boolean done;
    private long begunAt = -1;
    private double begunSpeed;

    /** {@code fixedYaw} in radians, NaN: nose ahead. */
    public GoTo(NeuPosition target, CruiseSpeeds cruise, double fixedYaw) {
        this(target, cruise, fixedYaw, false);
    }

    private GoTo(NeuPosition target, CruiseSpeeds cruise, double fixedYaw, boolean easing) {
        this.easing = easing;
        this.target = target;
        this.cruise = cruise;
        this.fixedYaw = fixedYaw;
    }

    /** The leg of a mission: gathers speed gently, as autopilots do on a planned path. */
    public static GoTo leg(NeuPosition target, CruiseSpeeds cruise, double fixedYaw) {
        return new GoTo(target, cruise, fixedYaw, true);
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        NeuPosition here = craft.body().position();
        done = here.distanceTo(target) < (easing ? LEG_REACHED_METERS : REACHED_METERS);
        double yaw = fixedYaw;
        if (Double.isNaN(yaw) && here.horizontalDistanceTo(target) > NOSE_AHEAD_METERS) {
            yaw = here.bearingTo(target);
        }
        MotionSetpoint.Reach reach = cruise.to(target, yaw);
        return easing ? reach.slowerThan(easedSpeed(craft, nowMillis)) : reach;
    }

    /** The acceleration grows by a metre per second squared each second until it is the airframe's own. */
    private double easedSpeed(SimulatedCraft craft, long nowMillis) {
        if (begunAt < 0) {
            begunAt = nowMillis;
            begunSpeed = craft.body().groundSpeed();
        }
        double seconds = (nowMillis - begunAt) / 1000.0;
        double easing = Math.min(seconds, EASING_SECONDS);
        double gained = EASING_JERK * easing * easing / 2;
        return begunSpeed + gained + EASING_JERK * EASING_SECONDS * (seconds - easing);
    }

    @Override
    public boolean done() {
        return done;
    }

    public NeuPosition target() {
        return target;
    }
}
