package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: follows a moving position target, extrapolated for up to three seconds (GUID_TIMEOUT). */
public final class MovingTargetManoeuvre implements Manoeuvre {
    private static final long FRESH_MILLIS = 3_000;

    private final Moving moving;
    private final CruiseSpeeds cruise;
    private final double yaw;
    private long begun = -1;

    /** A place and its velocity in m/s. */
    public record Moving(NeuPosition place, double north, double east, double up) {
        NeuPosition after(double seconds) {
            return new NeuPosition(
                    place.north() + north * seconds, place.east() + east * seconds, place.up() + up * seconds);
        }
    }

    /** {@code yaw} in radians; NaN: as it looks already. */
    public MovingTargetManoeuvre(Moving moving, CruiseSpeeds cruise, double yaw) {
        this.moving = moving;
        this.cruise = cruise;
        this.yaw = yaw;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (begun < 0) {
            begun = nowMillis;
        }
        long passed = nowMillis - begun;
        NeuPosition place = moving.after(Math.min(passed, FRESH_MILLIS) / 1000.0);
        double moves = passed < FRESH_MILLIS ? 1 : 0;
        return new MotionSetpoint.Track(
                cruise.to(place, yaw), moving.north() * moves, moving.east() * moves, moving.up() * moves);
    }
}
