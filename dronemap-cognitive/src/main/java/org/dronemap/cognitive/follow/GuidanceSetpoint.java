package org.dronemap.cognitive.follow;

import org.dronemap.core.geo.Geodetic;

/**
 * A setpoint for a drone that follows: position, velocity and heading for the moment that it arrives.
 *
 * @param eastward m/s
 * @param northward m/s
 * @param upward m/s
 * @param headingDegrees where it looks, 0 to 360 clockwise from north
 * @param doing what the leading is about
 */
public record GuidanceSetpoint(
        Geodetic point,
        double altitudeAmslMeters,
        double eastward,
        double northward,
        double upward,
        double headingDegrees,
        Phase doing) {
    /** The phase of the guidance. */
    public enum Phase {
        FOLLOWING,
        /** Nothing was heard of the target lately: it stays where it is. */
        HOLDING,
        /** It is too low to go anywhere. */
        CLIMBING,
        /** A fence keeps it from where it would be. */
        FENCED
    }
}
