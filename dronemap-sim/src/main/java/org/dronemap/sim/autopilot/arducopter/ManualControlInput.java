package org.dronemap.sim.autopilot.arducopter;

import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.VelocityManoeuvre;
import org.jspecify.annotations.Nullable;

/** MANUAL_CONTROL input that overrides the radio of the simulated ArduCopter for three seconds (RC_OVERRIDE_TIME). */
final class ManualControlInput {
    private static final long FRESH_MILLIS = 3_000;
    private static final double FULL = 1000;
    private static final double HALF = 500;
    private static final double DEAD_ZONE = 0.05;

    private final SimulatedParameters parameters;
    private @Nullable ManualControl latest;
    private long receivedAt;

    ManualControlInput(SimulatedParameters parameters) {
        this.parameters = parameters;
    }

    void set(ManualControl sticks, long nowMillis) {
        latest = sticks;
        receivedAt = nowMillis;
    }

    boolean isHeld(long nowMillis) {
        return latest != null && nowMillis - receivedAt < FRESH_MILLIS;
    }

    /** Speeds that LOITER makes of the sticks; null when nobody holds them. */
    VelocityManoeuvre.@Nullable Wanted wanted(long nowMillis) {
        ManualControl sticks = latest;
        if (sticks == null || !isHeld(nowMillis)) {
            return null;
        }
        double speed = parameters.value("LOIT_SPEED") / 100;
        double up = share((sticks.z() - HALF) / HALF);
        double vertical = parameters.value(up < 0 ? "PILOT_SPEED_DN" : "PILOT_SPEED_UP") / 100;
        return new VelocityManoeuvre.Wanted(
                true,
                share(sticks.x() / FULL) * speed,
                share(sticks.y() / FULL) * speed,
                up * vertical,
                Double.NaN,
                share(sticks.r() / FULL) * Math.toRadians(parameters.value("PILOT_Y_RATE")));
    }

    private static double share(double stick) {
        return Math.abs(stick) < DEAD_ZONE ? 0 : Math.max(-1, Math.min(1, stick));
    }
}
