package org.dronemap.core.mission;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Warns of likely mistakes in a planned mission, such as a very long leg; forbids nothing. Nothing of it is forbidden:
 * a sentence each, for people to look at. Items are numbered from 1 as on the vehicle; {@code from} is where the drone
 * is, null when that is not known.
 */
public final class MissionWarnings {
    private static final int FAR_METERS = 10_000;
    private static final int LONG_LEG_METERS = 20_000;
    private static final int LONG_WAY_METERS = 50_000;
    private static final int HIGH_METERS = 500;

    private MissionWarnings() {}

    private record Place(int number, Geodetic point) {}

    public static List<String> about(Mission mission, @Nullable Geodetic from) {
        List<Place> places = new ArrayList<>();
        List<String> doubts = new ArrayList<>();
        for (int index = 0; index < mission.items().size(); index++) {
            MissionItem item = mission.items().get(index);
            int number = index + 1;
            place(item).ifPresent(point -> places.add(new Place(number, point)));
            if (item instanceof MissionItem.Waypoint waypoint) {
                oddAltitude(number, waypoint.altitude()).ifPresent(doubts::add);
            }
        }
        longWay(places).ifPresent(sentence -> doubts.add(0, sentence));
        longLeg(places).ifPresent(sentence -> doubts.add(0, sentence));
        if (from != null) {
            far(places, from).ifPresent(sentence -> doubts.add(0, sentence));
        }
        return List.copyOf(doubts);
    }

    /** Where it flies to by that item. */
    private static Optional<Geodetic> place(MissionItem item) {
        return switch (item.kind()) {
            case WAYPOINT -> Optional.of(((MissionItem.Waypoint) item).point());
            case LAND -> Optional.ofNullable(((MissionItem.Land) item).place()).map(LandingPlace::point);
            case TAKE_OFF, RETURN_TO_LAUNCH, WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD, OTHER ->
                Optional.empty();
        };
    }

    /** About flying straight to a place. */
    public static List<String> about(Geodetic place, @Nullable Geodetic from) {
        double meters = from == null ? 0 : Geodesy.distanceMeters(from, place);
        return meters > FAR_METERS
                ? List.of("The place is " + kilometers(meters) + " away from the drone.")
                : List.of();
    }

    private static Optional<String> far(List<Place> places, Geodetic from) {
        List<Place> far = places.stream()
                .filter(place -> Geodesy.distanceMeters(from, place.point()) > FAR_METERS)
                .sorted(Comparator.comparingDouble(place -> -Geodesy.distanceMeters(from, place.point())))
                .toList();
        if (far.isEmpty()) {
            return Optional.empty();
        }
        Place farthest = far.get(0);
        String away = kilometers(Geodesy.distanceMeters(from, farthest.point())) + " away";
        return Optional.of(
                far.size() == 1
                        ? "Item " + farthest.number() + " is " + away + " from the drone."
                        : far.size() + " waypoints are more than " + FAR_METERS / 1000
                                + " km away from the drone; item " + farthest.number() + " is " + away + ".");
    }

    private static Optional<String> longLeg(List<Place> places) {
        for (int i = 1; i < places.size(); i++) {
            double meters = legMeters(places, i);
            if (meters > LONG_LEG_METERS) {
                return Optional.of("From item " + places.get(i - 1).number() + " to item "
                        + places.get(i).number() + " it is " + kilometers(meters) + ".");
            }
        }
        return Optional.empty();
    }

    private static Optional<String> longWay(List<Place> places) {
        double meters = 0;
        for (int i = 1; i < places.size(); i++) {
            meters += legMeters(places, i);
        }
        return meters > LONG_WAY_METERS
                ? Optional.of("The whole way is " + kilometers(meters) + ".")
                : Optional.empty();
    }

    private static double legMeters(List<Place> places, int end) {
        return Geodesy.distanceMeters(
                places.get(end - 1).point(), places.get(end).point());
    }

    private static Optional<String> oddAltitude(int number, Altitude altitude) {
        if (altitude.reference() != Altitude.Reference.HOME) {
            return Optional.empty();
        }
        String meters = String.format(Locale.ROOT, "%.0f m", altitude.meters());
        if (altitude.meters() < 0) {
            return Optional.of("Item " + number + " is at " + meters + ", lower than home.");
        }
        return altitude.meters() > HIGH_METERS
                ? Optional.of("Item " + number + " is " + meters + " above home.")
                : Optional.empty();
    }

    private static String kilometers(double meters) {
        return String.format(Locale.ROOT, "%.2f km", meters / 1000);
    }
}
