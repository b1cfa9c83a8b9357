package org.dronemap.core.separation;

/** A velocity over the ground, m/s to the east and to the north. */
public record GroundVelocity(double eastward, double northward) {
    public static final GroundVelocity NONE = new GroundVelocity(0, 0);

    /** The same with at least that speed in a direction of length 1. */
    GroundVelocity atLeast(double speed, GroundVelocity direction) {
        double has = eastward * direction.eastward() + northward * direction.northward();
        double more = Math.max(0, speed - has);
        return new GroundVelocity(eastward + direction.eastward() * more, northward + direction.northward() * more);
    }

    public double speed() {
        return Math.hypot(eastward, northward);
    }
}
