package org.dronemap.sim.autopilot.arduplane;

import java.util.function.BooleanSupplier;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.MotionSetpoint;

/** Flies a simulated ArduPlane in a mode of its pilot, of whom the throttle stick alone is known. */
final class PilotFlight implements Manoeuvre {
    private final boolean holdsHeight;
    private final BooleanSupplier stickLow;
    private final double slowest;
    private final CruiseSpeeds cruise;

    /** {@code holdsHeight}: the stick at its bottom only makes it slower, down to {@code slowest}. */
    PilotFlight(boolean holdsHeight, BooleanSupplier stickLow, double slowest, CruiseSpeeds cruise) {
        this.holdsHeight = holdsHeight;
        this.stickLow = stickLow;
        this.slowest = slowest;
        this.cruise = cruise;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        boolean low = stickLow.getAsBoolean();
        if (low && !holdsHeight) {
            return new MotionSetpoint.Glide();
        }
        return new MotionSetpoint.Wing(0, low ? slowest : cruise.horizontal(), 0, false);
    }
}
