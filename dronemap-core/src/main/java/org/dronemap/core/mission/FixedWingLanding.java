package org.dronemap.core.mission;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.geo.Geodesy;
import org.jspecify.annotations.Nullable;

/** Checks that a fixed wing has a straight way down to where a mission lets it land. */
final class FixedWingLanding {
    /** Less leaves no time to come down on the way. */
    private static final int NEAREST_METERS = 100;

    private static final int LOWEST_METERS = 10;
    /** Metres ahead for each metre down; on a steeper way it gets too fast. */
    private static final int FLATTEST_STEEP = 6;

    private static final String APPROACH = "a waypoint before the landing, at least " + NEAREST_METERS
            + " m from its place, at least " + LOWEST_METERS + " m above its ground, and " + FLATTEST_STEEP
            + " times as far away as it is high";
    private static final String NEEDS = "lands on a straight way down to a place";

    private FixedWingLanding() {}

    static Optional<MissionItemFault> fault(List<MissionItem> items, int index) {
        LandingPlace place = ((MissionItem.Land) items.get(index)).place();
        if (place == null) {
            return Optional.of(new MissionItemFault(
                    index,
                    "latitude",
                    "the place of the landing, -90 to 90 degrees",
                    NEEDS + "; give the landing a latitude and a longitude and put before it " + approach()
                            + ", or end with return to launch, after which it circles over its home"));
        }
        MissionItem.Waypoint before = before(items, index);
        if (before == null) {
            return Optional.of(new MissionItemFault(index, "type", APPROACH, NEEDS + "; put before it " + approach()));
        }
        return slope(before, place).map(why -> new MissionItemFault(index, "latitude", APPROACH, why));
    }

    private static String approach() {
        return APPROACH.replace(" before the landing", "");
    }

    /** Where it flies before; what is done on the way does not matter. */
    private static MissionItem.@Nullable Waypoint before(List<MissionItem> items, int index) {
        for (int item = index - 1; item >= 0; item--) {
            switch (items.get(item).kind()) {
                case WAYPOINT -> {
                    return (MissionItem.Waypoint) items.get(item);
                }
                case WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD -> {}
                case TAKE_OFF, RETURN_TO_LAUNCH, LAND, OTHER -> {
                    return null;
                }
            }
        }
        return null;
    }

    private static Optional<String> slope(MissionItem.Waypoint before, LandingPlace place) {
        if (before.altitude().reference() != place.ground().reference()) {
            return Optional.of(
                    NEEDS + "; give the landing's altitude and that of the waypoint before it both above home"
                            + " or both above sea level");
        }
        double far = Geodesy.distanceMeters(before.point(), place.point());
        double high = before.altitude().meters() - place.ground().meters();
        boolean fits = far >= NEAREST_METERS && high >= LOWEST_METERS && far >= high * FLATTEST_STEEP;
        return fits
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s; it needs before it %s, and the waypoint before it is %.0f m away and %.0f m high",
                        NEEDS,
                        approach(),
                        far,
                        high));
    }
}
