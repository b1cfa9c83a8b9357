package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;

/** A manoeuvre of a simulated vehicle: gives the motors their setpoint in each step. */
public interface Manoeuvre {
    MotionSetpoint fly(SimulatedCraft craft, long nowMillis);

    /** True once it has brought about what it is for. */
    default boolean done() {
        return false;
    }
}
