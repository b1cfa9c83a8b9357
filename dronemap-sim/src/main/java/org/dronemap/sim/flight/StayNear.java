package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** Simulated manoeuvre: stops, and drives back when it has drifted out of a circle around where it stopped. */
public final class StayNear implements Manoeuvre {
    private static final MotionSetpoint STOP = new MotionSetpoint.Velocity(0, 0, 0, Double.NaN);

    private final NeuPosition place;
    private final CruiseSpeeds cruise;
    private final double radius;

    public StayNear(SimulatedCraft craft, CruiseSpeeds cruise, double radius) {
        this.place = craft.body().stoppingPoint();
        this.cruise = cruise;
        this.radius = radius;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        return craft.body().position().horizontalDistanceTo(place) <= radius ? STOP : cruise.to(place, Double.NaN);
    }
}
