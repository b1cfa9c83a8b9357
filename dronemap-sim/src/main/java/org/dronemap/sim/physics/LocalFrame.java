package org.dronemap.sim.physics;

/**
 * The simulator's local frame: a flat piece of the earth around an origin in degrees and metres AMSL. Good to a few
 * centimetres within the some kilometres that a multicopter flies.
 */
public record LocalFrame(double latitude, double longitude, double altitudeAmsl) {
    private static final double METERS_PER_DEGREE = 111_319.490_793;

    public double latitudeOf(NeuPosition position) {
        return latitude + position.north() / METERS_PER_DEGREE;
    }

    public double longitudeOf(NeuPosition position) {
        return longitude + position.east() / (METERS_PER_DEGREE * eastScale());
    }

    public double altitudeOf(NeuPosition position) {
        return altitudeAmsl + position.up();
    }

    public NeuPosition locate(double atLatitude, double atLongitude, double up) {
        return new NeuPosition(
                (atLatitude - latitude) * METERS_PER_DEGREE,
                (atLongitude - longitude) * METERS_PER_DEGREE * eastScale(),
                up);
    }

    /** The frame whose origin lies at {@code offset} in this one. */
    public LocalFrame shifted(NeuPosition offset) {
        return new LocalFrame(latitudeOf(offset), longitudeOf(offset), altitudeOf(offset));
    }

    private double eastScale() {
        return Math.cos(Math.toRadians(latitude));
    }
}
