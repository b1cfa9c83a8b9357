package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre: climbs to the return height, flies home, waits there and lands. */
public final class ReturnHome implements Manoeuvre {
    private static final double NEAR_METERS = 1.0;
    /** Between its stages it settles for a moment. */
    private static final long SETTLING_MILLIS = 800;

    private final CruiseSpeeds cruise;
    private final NeuPosition start;
    private final NeuPosition above;
    private final long waitMillis;
    private final GoTo leg;
    private long climbedAt = -1;
    private long waitingSince = -1;
    private @Nullable Landing landing;

    /** {@code returnHeight} in metres above home; one who is higher stays as high. */
    public ReturnHome(SimulatedCraft craft, CruiseSpeeds cruise, double returnHeight, long waitMillis) {
        this(craft, cruise, craft.homePosition(), returnHeight, waitMillis);
    }

    /** The same to another place than its home. */
    public ReturnHome(
            SimulatedCraft craft, CruiseSpeeds cruise, NeuPosition place, double returnHeight, long waitMillis) {
        NeuPosition homePosition = craft.homePosition();
        double up = Math.max(craft.body().up(), homePosition.up() + returnHeight);
        this.cruise = cruise;
        this.start = craft.body().stoppingPoint().withUp(up);
        this.above = place.withUp(up);
        this.leg = GoTo.leg(above, cruise, Double.NaN);
        this.waitMillis = waitMillis;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (landing != null) {
            return landing.fly(craft, nowMillis);
        }
        NeuPosition here = craft.body().position();
        if (craft.landed()) {
            landing = new Landing(craft, cruise);
            return landing.fly(craft, nowMillis);
        }
        if (climbedAt < 0 && here.up() >= above.up() - NEAR_METERS) {
            climbedAt = nowMillis;
        }
        if (climbedAt < 0 || nowMillis - climbedAt < SETTLING_MILLIS) {
            return cruise.to(start, Double.NaN);
        }
        MotionSetpoint setpoint = leg.fly(craft, nowMillis);
        if (leg.done() && waitingSince < 0) {
            waitingSince = nowMillis;
        }
        if (waitingSince >= 0 && nowMillis - waitingSince >= waitMillis + SETTLING_MILLIS) {
            landing = new Landing(craft, cruise);
        }
        return setpoint;
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
