package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Setpoint;
import org.jspecify.annotations.Nullable;

/** Flies with a velocity while setpoints keep coming; falls silent: stops. */
public final class Drive implements Manoeuvre {
    private static final long FRESH_MILLIS = 3_000;

    private final Setpoint.Velocity velocity;
    private final Cruise cruise;
    private long begun = -1;
    private @Nullable Hover stop;

    public Drive(Setpoint.Velocity velocity, Cruise cruise) {
        this.velocity = velocity;
        this.cruise = cruise;
    }

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        if (begun < 0) {
            begun = nowMillis;
        }
        if (nowMillis - begun < FRESH_MILLIS) {
            return velocity;
        }
        if (stop == null) {
            stop = new Hover(craft, cruise);
        }
        return stop.fly(craft, nowMillis);
    }
}
