package org.dronemap.sim.flight;

import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;

/** The speeds in m/s that a simulated vehicle flies with by default; commands may change them. Owned by its vehicle. */
public final class CruiseSpeeds {
    private double horizontal;
    private double climb;
    private double sink;
    private double touchdown;

    public CruiseSpeeds(double horizontal, double climb, double sink, double touchdown) {
        set(horizontal, climb, sink, touchdown);
    }

    public void set(double newHorizontal, double newClimb, double newSink, double newTouchdown) {
        horizontal = newHorizontal;
        climb = newClimb;
        sink = newSink;
        touchdown = newTouchdown;
    }

    public void setHorizontal(double metersPerSecond) {
        horizontal = metersPerSecond;
    }

    public void setClimb(double metersPerSecond) {
        climb = metersPerSecond;
    }

    public void setSink(double metersPerSecond) {
        sink = metersPerSecond;
    }

    public double touchdown() {
        return touchdown;
    }

    public double horizontal() {
        return horizontal;
    }

    public MotionSetpoint.Reach to(NeuPosition target, double yaw) {
        return new MotionSetpoint.Reach(target, horizontal, climb, sink, yaw);
    }

    /** Lands: fast while high, slowly near the ground. */
    public MotionSetpoint.Reach downAt(NeuPosition place, double up) {
        double speed = up > 10 ? sink : touchdown;
        return new MotionSetpoint.Reach(place.withUp(-10), horizontal, climb, speed, Double.NaN);
    }
}
