package org.dronemap.cognitive.follow;

/**
 * Limits for guiding a following drone: speed, lowest and highest altitude, and the delay of its downlink.
 *
 * @param speed over the ground, m/s
 * @param lowestAmslMeters it is never led below, and nowhere before it is that high
 * @param highestAmslMeters it is never led above
 * @param downlinkSeconds from saying where it shall be to its hearing that
 */
public record GuidanceLimits(double speed, double lowestAmslMeters, double highestAmslMeters, double downlinkSeconds) {
    public GuidanceLimits {
        if (!(speed > 0)) {
            throw new IllegalArgumentException("a speed is more than 0 m/s: " + speed);
        }
        if (!(lowestAmslMeters <= highestAmslMeters)) {
            throw new IllegalArgumentException(
                    "nothing is between " + lowestAmslMeters + " and " + highestAmslMeters + " m");
        }
        if (!(downlinkSeconds >= 0)) {
            throw new IllegalArgumentException("a delay is 0 or more seconds: " + downlinkSeconds);
        }
    }
}
