package org.dronemap.core.zone;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Builds the predicted route of a mission, leg by leg, from the drone's present position. Used once, by one thread. */
final class MissionRouteBuilder {
    /** How high a vehicle goes before it returns, unless it is higher already: the highest that autopilots come with. */
    static final double RETURN_HEIGHT_METERS = 60;

    private static final String HERE = "where the drone is";

    private final DroneState drone;
    private final List<Leg> legs = new ArrayList<>();
    private @Nullable String doubt;
    private @Nullable Geodetic place;
    /** Nothing: not known. */
    private List<Altitude> altitudes;

    private String placeWords = HERE;

    MissionRouteBuilder(DroneState drone) {
        this.drone = drone;
        Position position = drone.position();
        this.place = position == null ? null : position.point();
        this.altitudes = altitudes(position);
    }

    /** One, in metres from what is known; nothing when it is not known how high that is. */
    static List<Altitude> altitudes(@Nullable Position position) {
        Double aboveHome = position == null ? null : position.altitudeAboveHomeMeters();
        Double amsl = position == null ? null : position.altitudeAmslMeters();
        if (aboveHome != null && Math.abs(aboveHome) <= Altitude.HIGHEST_PLANNED_METERS) {
            return List.of(Altitude.aboveHome(aboveHome));
        }
        return amsl != null && Math.abs(amsl) <= Altitude.HIGHEST_PLANNED_METERS
                ? List.of(new Altitude(amsl, Altitude.Reference.AMSL))
                : List.of();
    }

    /** Nobody knows where it will be started from; that is checked when it is. */
    MissionRouteBuilder fromAnywhere() {
        placeWords = "";
        return this;
    }

    /** From the item with this index on. */
    PredictedRoute through(List<MissionItem> items, int first) {
        for (int index = first; index < items.size(); index++) {
            step(items.get(index), "item " + (index + 1));
        }
        return new PredictedRoute(legs, doubt);
    }

    private void step(MissionItem item, String words) {
        switch (item.kind()) {
            case TAKE_OFF -> {
                takeOff(((MissionItem.TakeOff) item).altitudeMeters(), "The take-off of " + words);
                placeWords = placeWords.isEmpty() ? placeWords : words;
            }
            case WAYPOINT -> {
                MissionItem.Waypoint waypoint = (MissionItem.Waypoint) item;
                flyTo(waypoint.point(), waypoint.altitude(), words);
            }
            case LAND -> land((MissionItem.Land) item, words);
            case RETURN_TO_LAUNCH -> flyHome(words);
            case OTHER ->
                doubtful("What " + words + " (" + ((MissionItem.Other) item).description()
                        + ") does to the way is not known");
            case WAIT, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD -> {}
        }
    }

    /** A fixed wing comes down on the way, others at its end. */
    private void land(MissionItem.Land item, String words) {
        LandingPlace there = item.place();
        if (there == null) {
            column("The landing of " + words, altitudes, true);
            return;
        }
        List<Altitude> all = with(there.ground());
        leg("The way from " + placeWords + " to " + words, there.point(), all);
        place = there.point();
        placeWords = words;
        altitudes = all;
        column("The landing of " + words, all, true);
    }

    /** Straight up from where it is. */
    PredictedRoute takeOff(double altitudeMeters, String words) {
        List<Altitude> all = with(Altitude.aboveHome(altitudeMeters));
        column(words, all, !drone.airborne());
        altitudes = drone.airborne() ? all : List.of(Altitude.aboveHome(altitudeMeters));
        return new PredictedRoute(legs, doubt);
    }

    PredictedRoute flyTo(Geodetic point, Altitude altitude, String words) {
        leg("The way from " + placeWords + " to " + words, point, with(altitude));
        place = point;
        placeWords = words;
        altitudes = List.of(altitude);
        return new PredictedRoute(legs, doubt);
    }

    private void flyHome(String words) {
        Home home = drone.home();
        if (home == null) {
            doubtful("Where the home is, is not known");
            return;
        }
        List<Altitude> all = with(Altitude.aboveHome(RETURN_HEIGHT_METERS));
        leg("The return of " + words + " from " + placeWords + " home", home.point(), all);
        place = home.point();
        placeWords = "home";
        altitudes = all;
        column("The landing at home of " + words, all, true);
    }

    private void column(String words, List<Altitude> all, boolean toTheGround) {
        Geodetic here = place;
        if (here != null) {
            legs.add(new Leg(words, here, here, new LegHeights(all, toTheGround)));
        } else if (!placeWords.isEmpty()) {
            doubtful("Where the drone is, is not known");
        }
    }

    private void leg(String words, Geodetic to, List<Altitude> all) {
        Geodetic here = place;
        if (here != null) {
            legs.add(new Leg(words, here, to, new LegHeights(all, false)));
        } else if (!placeWords.isEmpty()) {
            doubtful("Where the drone is, is not known");
        } else {
            // At least the place itself is known.
            legs.add(new Leg(words.replace("The way from  to ", "The way to "), to, to, new LegHeights(all, false)));
        }
    }

    private List<Altitude> with(Altitude altitude) {
        return altitudes.isEmpty() && !placeWords.isEmpty()
                ? List.of()
                : Stream.concat(altitudes.stream(), Stream.of(altitude)).toList();
    }

    private void doubtful(String why) {
        if (doubt == null) {
            doubt = why;
        }
    }
}
