package org.dronemap.core.separation;

/** A velocity over the ground, m/s to the east and to the north. */
public record GroundVelocity(double east, double north) {
    public static final GroundVelocity NONE = new GroundVelocity(0, 0);

    public double speed() {
        return Math.hypot(east, north);
    }
}
