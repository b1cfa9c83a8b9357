package org.dronemap.core.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Compares a mission with the one read back from a vehicle, allowing for rounding on the wire. */
public final class MissionComparison {
    private static final double SAME_POINT_METERS = 0.1;
    private static final double SAME_ALTITUDE_METERS = 0.05;
    private static final double SAME_SECONDS = 0.1;

    private MissionComparison() {}

    /** A phrase that says how they differ, such as "5 items instead of 4; items 2, 3 differ"; empty when they do not. */
    public static Optional<String> difference(List<MissionItem> expected, List<MissionItem> found) {
        List<String> parts = new ArrayList<>();
        if (expected.size() != found.size()) {
            parts.add(CountText.of(found.size(), "item") + " instead of " + expected.size());
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
        if (a.kind() != b.kind()) {
            return false;
        }
        return switch (a.kind()) {
            case WAYPOINT -> same((MissionItem.Waypoint) a, (MissionItem.Waypoint) b);
            case TAKE_OFF ->
                near(
                        ((MissionItem.TakeOff) a).altitudeMeters(),
                        ((MissionItem.TakeOff) b).altitudeMeters(),
                        SAME_ALTITUDE_METERS);
            case WAIT -> near(((MissionItem.Wait) a).seconds(), ((MissionItem.Wait) b).seconds(), SAME_SECONDS);
            case LOOK_AT -> same((MissionItem.LookAt) a, (MissionItem.LookAt) b);
            case LAND -> same(((MissionItem.Land) a).place(), ((MissionItem.Land) b).place());
            case RETURN_TO_LAUNCH, TAKE_PHOTO, SET_SERVO, LOOK_AHEAD, OTHER -> a.equals(b);
        };
    }

    private static boolean same(MissionItem.Waypoint one, MissionItem.Waypoint other) {
        return same(one.point(), other.point())
                && same(one.altitude(), other.altitude())
                && near(one.holdSeconds(), other.holdSeconds(), SAME_SECONDS);
    }

    private static boolean same(MissionItem.LookAt one, MissionItem.LookAt other) {
        return same(one.point(), other.point()) && same(one.altitude(), other.altitude());
    }

    private static boolean same(@Nullable LandingPlace one, @Nullable LandingPlace other) {
        if (one == null || other == null) {
            return one == null && other == null;
        }
        return same(one.point(), other.point()) && same(one.ground(), other.ground());
    }

    private static boolean same(Geodetic one, Geodetic other) {
        return Geodesy.distanceMeters(one, other) < SAME_POINT_METERS;
    }

    private static boolean same(Altitude one, Altitude other) {
        return one.reference() == other.reference() && near(one.meters(), other.meters(), SAME_ALTITUDE_METERS);
    }

    private static boolean near(double a, double b, double tolerance) {
        return Math.abs(a - b) <= tolerance;
    }
}
