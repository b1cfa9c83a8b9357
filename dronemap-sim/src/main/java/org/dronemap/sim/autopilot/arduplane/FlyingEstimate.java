package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.sim.flight.SimulatedCraft;

/**
 * The simulated ArduPlane's guess from its speed whether it flies: it takes itself for flying soon after it began to
 * roll, and until three seconds after it stopped.
 */
final class FlyingEstimate {
    private static final long STEP_MILLIS = 200;
    private static final double KEPT = 0.85;
    private static final double FLYING_ARMED = 0.1;
    private static final double FLYING_DISARMED = 0.9;
    private static final double MOVING_SPEED = 1.5;
    private static final double SURE_TO_BE_UP_METERS = 0.05;

    private double probability;
    private long checkedAt = -STEP_MILLIS;
    private long lastFlyingAt;
    private long startedAt;

    void check(SimulatedCraft craft, boolean lifting, long nowMillis) {
        while (nowMillis - checkedAt >= STEP_MILLIS) {
            checkedAt += STEP_MILLIS;
            boolean up = craft.body().up() > SURE_TO_BE_UP_METERS;
            boolean moving = craft.body().groundSpeed() >= MOVING_SPEED;
            boolean flies = lifting || (craft.armed() ? moving || up : moving && up);
            boolean before = isFlying(craft.armed());
            probability = KEPT * probability + (flies ? 1 - KEPT : 0);
            if (isFlying(craft.armed())) {
                lastFlyingAt = checkedAt;
                startedAt = before ? startedAt : checkedAt;
            }
        }
    }

    boolean isFlying(boolean armed) {
        return probability >= (armed ? FLYING_ARMED : FLYING_DISARMED);
    }

    /** Milliseconds since it last took itself for flying. */
    long stillFor(long nowMillis) {
        return nowMillis - lastFlyingAt;
    }

    /** Milliseconds that it has been flying. */
    long flyingFor(long nowMillis) {
        return nowMillis - startedAt;
    }
}
