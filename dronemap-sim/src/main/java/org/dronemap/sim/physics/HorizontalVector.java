package org.dronemap.sim.physics;

/** A horizontal vector (north, east) in the simulator's flight physics: metres, m/s or m/s². */
record HorizontalVector(double north, double east) {
    static final HorizontalVector ZERO = new HorizontalVector(0, 0);

    HorizontalVector plus(HorizontalVector other) {
        return new HorizontalVector(north + other.north, east + other.east);
    }

    HorizontalVector minus(HorizontalVector other) {
        return new HorizontalVector(north - other.north, east - other.east);
    }

    HorizontalVector times(double factor) {
        return new HorizontalVector(north * factor, east * factor);
    }

    double dot(HorizontalVector other) {
        return north * other.north + east * other.east;
    }

    double length() {
        return Math.hypot(north, east);
    }

    /** In the same direction, and no longer than that. */
    HorizontalVector within(double longest) {
        double length = length();
        return length > longest ? times(longest / length) : this;
    }
}
