package org.dronemap.sim.physics;

/** A place in the simulator: metres north, east and up of a {@link LocalFrame}'s origin. */
public record NeuPosition(double north, double east, double up) {
    public double horizontalDistanceTo(NeuPosition other) {
        return Math.hypot(other.north - north, other.east - east);
    }

    public double distanceTo(NeuPosition other) {
        return Math.hypot(horizontalDistanceTo(other), other.up - up);
    }

    /** Direction of {@code other} in radians, 0 = north, clockwise. */
    public double bearingTo(NeuPosition other) {
        return Math.atan2(other.east - east, other.north - north);
    }

    public NeuPosition withUp(double newUp) {
        return new NeuPosition(north, east, newUp);
    }
}
