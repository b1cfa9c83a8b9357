package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.jspecify.annotations.Nullable;

/** Simulated manoeuvre: flies at a commanded velocity, and stops when no more setpoints come. */
public final class VelocityManoeuvre implements Manoeuvre {
    private static final long FRESH_MILLIS = 3_000;

    private final Wanted wanted;
    private final CruiseSpeeds cruise;
    private long begun = -1;
    private @Nullable Hover stop;

    /**
     * Speeds in m/s.
     *
     * @param ofItsOwn forward and right as it looks, else north and east
     * @param yaw where to look, radians; NaN: where it looks already
     * @param yawRate radians a second clockwise; 0: none
     */
    public record Wanted(boolean ofItsOwn, double forward, double right, double up, double yaw, double yawRate) {
        /** As it stands now. */
        MotionSetpoint.Velocity of(SimulatedCraft craft) {
            double looks = craft.body().yaw();
            double turned = ofItsOwn ? looks : 0;
            // A turn is asked for a little ahead of where it looks, at each step.
            double look = yawRate == 0 ? yaw : looks + Math.signum(yawRate) * Math.min(1, Math.abs(yawRate));
            return new MotionSetpoint.Velocity(
                    forward * Math.cos(turned) - right * Math.sin(turned),
                    forward * Math.sin(turned) + right * Math.cos(turned),
                    up,
                    look);
        }
    }

    public VelocityManoeuvre(Wanted wanted, CruiseSpeeds cruise) {
        this.wanted = wanted;
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begun < 0) {
            begun = nowMillis;
        }
        if (nowMillis - begun < FRESH_MILLIS) {
            return wanted.of(craft);
        }
        if (stop == null) {
            stop = new Hover(craft, cruise);
        }
        return stop.fly(craft, nowMillis);
    }
}
