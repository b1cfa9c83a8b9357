package org.dronemap.sim.physics;

/** Metres, m/s or m/s² over the ground. */
record Flat(double north, double east) {
    static final Flat ZERO = new Flat(0, 0);

    Flat plus(Flat other) {
        return new Flat(north + other.north, east + other.east);
    }

    Flat minus(Flat other) {
        return new Flat(north - other.north, east - other.east);
    }

    Flat times(double factor) {
        return new Flat(north * factor, east * factor);
    }

    double dot(Flat other) {
        return north * other.north + east * other.east;
    }

    double length() {
        return Math.hypot(north, east);
    }

    /** In the same direction, and no longer than that. */
    Flat within(double longest) {
        double length = length();
        return length > longest ? times(longest / length) : this;
    }
}
