package org.dronemap.cognitive.follow;

/**
 * The position that a following drone is to keep to its target: side, distance on the ground and altitude.
 *
 * @param distanceMeters on the ground, 0 to 200
 * @param altitudeAmslMeters its own height
 */
public record StandOff(StandOffSide side, double distanceMeters, double altitudeAmslMeters) {
    private static final double FARTHEST = 200;

    public StandOff {
        if (!(distanceMeters >= 0 && distanceMeters <= FARTHEST)) {
            throw new IllegalArgumentException("a distance is 0 to 200 metres: " + distanceMeters);
        }
        if (!Double.isFinite(altitudeAmslMeters)) {
            throw new IllegalArgumentException("an altitude is a number of metres: " + altitudeAmslMeters);
        }
    }
}
