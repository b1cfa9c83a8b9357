package org.dronemap.core.zone;

import java.util.ArrayDeque;
import java.util.Deque;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.jspecify.annotations.Nullable;

/**
 * Predicts a drone's position a few seconds ahead from its last positions, to warn of zone breaches. Owned by one
 * thread.
 */
final class CoursePredictor {
    private static final long SHORTEST_NANOS = 300_000_000L;
    private static final long LONGEST_NANOS = 1_200_000_000L;
    private static final long STANDS_NANOS = 1_500_000_000L;
    /** Slower than this it may as well stand. */
    private static final double STANDING_METERS_PER_SECOND = 0.3;

    private static final double METERS_PER_DEGREE = 111_195;

    private record Fix(long nanos, Geodetic point, Position position) {}

    private final Deque<Fix> fixes = new ArrayDeque<>();

    /** The same place again is no news, until so much time has passed that the drone must be standing there. */
    void add(long nanos, Geodetic point, Position position) {
        Fix last = fixes.peekLast();
        if (last != null && last.position().equals(position) && nanos - last.nanos() < STANDS_NANOS) {
            return;
        }
        fixes.addLast(new Fix(nanos, point, position));
        while (fixes.size() > 2 && nanos - fixes.getFirst().nanos() > LONGEST_NANOS) {
            fixes.removeFirst();
        }
    }

    /** Where it will be if it goes on like this; null when it stands, or nothing is known of the last second. */
    @Nullable
    Prediction ahead(double seconds) {
        Fix first = fixes.peekFirst();
        Fix last = fixes.peekLast();
        if (first == null || last == null) {
            return null;
        }
        long span = last.nanos() - first.nanos();
        if (span < SHORTEST_NANOS || span > 3 * LONGEST_NANOS) {
            return null;
        }
        double share = seconds * 1e9 / span;
        PlanePoint moved = LocalPlane.offset(first.point(), last.point());
        Double aboveHome = ahead(
                first.position().altitudeAboveHomeMeters(), last.position().altitudeAboveHomeMeters(), share);
        Double amsl =
                ahead(first.position().altitudeAmslMeters(), last.position().altitudeAmslMeters(), share);
        double climbed = aboveHome == null || last.position().altitudeAboveHomeMeters() == null
                ? 0
                : aboveHome - last.position().altitudeAboveHomeMeters();
        double way = Math.hypot(Math.hypot(moved.eastMeters(), moved.northMeters()) * share, climbed);
        if (way < STANDING_METERS_PER_SECOND * seconds) {
            return null;
        }
        Geodetic point = moved(last.point(), moved, share);
        return new Prediction(point, new Position(point, amsl, aboveHome));
    }

    /** A place in the future. */
    record Prediction(Geodetic point, Position position) {}

    private static @Nullable Double ahead(@Nullable Double before, @Nullable Double now, double share) {
        return before == null || now == null ? now : Double.valueOf(now + (now - before) * share);
    }

    private static Geodetic moved(Geodetic from, PlanePoint moved, double share) {
        double latitude = from.latitudeDegrees() + moved.northMeters() * share / METERS_PER_DEGREE;
        double across = METERS_PER_DEGREE * Math.max(0.01, Math.cos(Math.toRadians(from.latitudeDegrees())));
        double longitude = from.longitudeDegrees() + moved.eastMeters() * share / across;
        double wrapped = longitude > 180 ? longitude - 360 : longitude < -180 ? longitude + 360 : longitude;
        return new Geodetic(Math.max(-90, Math.min(90, latitude)), wrapped);
    }
}
