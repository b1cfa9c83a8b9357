package org.dronemap.ws.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.plan.Fix;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.Way;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Mission;

/** Writes a tour as the mission that its drone carries: all heights above sea level, but the take-off's. */
final class PlanMissions {
    private static final double HIGHEST_TAKE_OFF_METERS = 500;
    private static final double LONGEST_HOLD_SECONDS = 3_600;

    private final Craft craft;
    private final boolean landsAnywhere;

    PlanMissions(Craft craft, VehicleKind kind) {
        this.craft = craft;
        // An aeroplane needs its own way of coming down.
        this.landsAnywhere = kind != VehicleKind.FIXED_WING;
    }

    /** Why no drone can carry it, as a sentence. */
    Optional<String> fault(Tour tour) {
        int items = items(tour).size();
        if (items > Mission.MAX_ITEMS) {
            return Optional.of("The tour of the drone " + craft.id() + " takes " + items
                    + " items, and a mission holds " + Mission.MAX_ITEMS + ".");
        }
        double longest = 0;
        for (int stop = 0; stop < tour.stops().size(); stop++) {
            longest = Math.max(longest, hold(tour, stop));
        }
        return longest > LONGEST_HOLD_SECONDS
                ? Optional.of("The drone " + craft.id() + " would wait for " + Math.round(longest)
                        + " s at a waypoint, and a mission lets it wait for 3600 s.")
                : Optional.empty();
    }

    List<MissionItemView> items(Tour tour) {
        List<MissionItemView> items = new ArrayList<>();
        List<Way> ways = tour.ways();
        for (int number = 0; number < ways.size(); number++) {
            boolean last = number == ways.size() - 1;
            List<Fix> fixes = ways.get(number).fixes();
            int begin = 1;
            if (number == 0 && craft.takesOff()) {
                takeOff(items, fixes.get(1).place());
                begin = last ? 2 : Math.min(2, fixes.size() - 1);
            }
            int end = last && craft.lands() ? fixes.size() - 1 : fixes.size();
            for (int i = begin; i < end; i++) {
                boolean arrives = !last && i == fixes.size() - 1;
                items.add(waypoint(fixes.get(i).place(), arrives ? hold(tour, number) : 0));
            }
        }
        if (craft.lands()) {
            items.add(landsAnywhere ? simple("land") : simple("returnToLaunch"));
        }
        return items;
    }

    /** Until its next way begins: its task, and what waiting keeps drones apart. */
    private static double hold(Tour tour, int stop) {
        return Math.max(
                0, tour.way(stop + 1).departsSeconds() - tour.stops().get(stop).arrivesSeconds());
    }

    private void takeOff(List<MissionItemView> items, Place top) {
        double height = top.altitudeAmslMeters() - craft.homeAmslMeters();
        double climbed = Math.max(1, Math.min(HIGHEST_TAKE_OFF_METERS, height));
        items.add(new MissionItemView("takeOff", null, null, climbed, null, null, null));
        if (climbed != height) {
            // Straight up all the same.
            items.add(waypoint(top, 0));
        }
    }

    private static MissionItemView waypoint(Place place, double holdSeconds) {
        Geodetic point = place.point();
        return new MissionItemView(
                "waypoint",
                point.latitudeDegrees(),
                point.longitudeDegrees(),
                place.altitudeAmslMeters(),
                "amsl",
                holdSeconds,
                null);
    }

    private static MissionItemView simple(String type) {
        return new MissionItemView(type, null, null, null, null, null, null);
    }
}
