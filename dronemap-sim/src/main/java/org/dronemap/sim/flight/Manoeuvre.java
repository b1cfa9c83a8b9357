package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Setpoint;

/** Something a vehicle is flying just now: asked before each step what the motors shall do. */
public interface Manoeuvre {
    Setpoint fly(Craft craft, long nowMillis);

    /** True once it has brought about what it is for. */
    default boolean done() {
        return false;
    }
}
