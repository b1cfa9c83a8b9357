package org.dronemap.core.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronemap.core.geo.Geodesy;

/** Whether two missions are the same on the wire, where positions are rounded to 1e-7 degrees. */
public final class MissionComparison {
    private static final double SAME_POINT_METERS = 0.1;
    private static final double SAME_ALTITUDE_METERS = 0.05;
    private static final double SAME_SECONDS = 0.1;

    private MissionComparison() {}

    /** A phrase that says how they differ, such as "5 items instead of 4; items 2, 3 differ"; empty when they do not. */
    public static Optional<String> difference(List<MissionItem> expected, List<MissionItem> found) {
        List<String> parts = new ArrayList<>();
        if (expected.size() != found.size()) {
            parts.add(Counted.of(found.size(), "item") + " instead of " + expected.size());
        }
        List<Integer> differing = new ArrayList<>();
        for (int index = 0; index < Math.min(expected.size(), found.size()); index++) {
            if (!same(expected.get(index), found.get(index))) {
                differing.add(index + 1);
            }
        }
        if (!differing.isEmpty()) {
            String numbers = differing.stream().map(String::valueOf).collect(Collectors.joining(", "));
            parts.add((differing.size() == 1 ? "item " : "items ")
                    + numbers
                    + (differing.size() == 1 ? " differs" : " differ"));
        }
        return parts.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", parts));
    }

    private static boolean same(MissionItem a, MissionItem b) {
        if (a instanceof MissionItem.Waypoint one && b instanceof MissionItem.Waypoint other) {
            return one.altitude().reference() == other.altitude().reference()
                    && Geodesy.distanceMeters(one.point(), other.point()) < SAME_POINT_METERS
                    && near(one.altitude().meters(), other.altitude().meters(), SAME_ALTITUDE_METERS)
                    && near(one.holdSeconds(), other.holdSeconds(), SAME_SECONDS);
        }
        if (a instanceof MissionItem.TakeOff one && b instanceof MissionItem.TakeOff other) {
            return near(one.altitudeMeters(), other.altitudeMeters(), SAME_ALTITUDE_METERS);
        }
        return a.equals(b);
    }

    private static boolean near(double a, double b, double tolerance) {
        return Math.abs(a - b) <= tolerance;
    }
}
