package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.PlanePoint;
import org.jspecify.annotations.Nullable;

/**
 * Computes the position and velocity that a following drone needs to keep its place beside a moving target. Owned by
 * its {@link StandOffGuidance}.
 */
final class StandOffPosition {
    /** A course that is slower than this is none. */
    private static final double WALKS = 0.6;
    /** Round its target it flies no faster, m/s. */
    private static final double SWING = 2.5;

    private static final double SWING_GAIN = 0.8;

    private final TrackedTarget filter;
    /** Radians clockwise from north, from the target to the drone; NaN: not begun. */
    private double bearing = Double.NaN;

    /** Positions of target and drone, and the velocity that the drone needs, in m/s. */
    record Wanted(PlanePoint target, PlanePoint spot, double eastward, double northward) {}

    StandOffPosition(TrackedTarget filter) {
        this.filter = filter;
    }

    /** {@code seconds}: since it was asked before. */
    @Nullable
    Wanted at(Instant time, StandOff standOff, double seconds) {
        PlanarMotion target = filter.at(time);
        if (target == null) {
            return null;
        }
        double swing = swing(standOff, target);
        bearing += swing * seconds;
        double distance = standOff.distanceMeters();
        double east = distance * Math.sin(bearing);
        double north = distance * Math.cos(bearing);
        return new Wanted(
                target.spot(),
                new PlanePoint(target.east() + east, target.north() + north),
                target.eastward() + north * swing,
                target.northward() - east * swing);
    }

    /** Radians a second, clockwise. */
    private double swing(StandOff standOff, PlanarMotion target) {
        StandOffSide side = standOff.side();
        if (side instanceof StandOffSide.Orbit orbit) {
            if (Double.isNaN(bearing)) {
                bearing = 0;
            }
            return Math.toRadians(orbit.degreesPerSecond());
        }
        double wanted = wanted(side, target);
        if (Double.isNaN(bearing)) {
            bearing = wanted;
        }
        double off = Math.IEEEremainder(wanted - bearing, 2 * Math.PI);
        double most = SWING / Math.max(1, standOff.distanceMeters());
        return Math.max(-most, Math.min(most, off * SWING_GAIN));
    }

    private double wanted(StandOffSide side, PlanarMotion target) {
        if (side instanceof StandOffSide.Fixed fixed) {
            return Math.toRadians(fixed.bearingDegrees());
        }
        if (target.speed() < WALKS) {
            return Double.isNaN(bearing) ? 0 : bearing;
        }
        double course = Math.atan2(target.eastward(), target.northward());
        return side instanceof StandOffSide.Ahead ? course : course + Math.PI;
    }
}
