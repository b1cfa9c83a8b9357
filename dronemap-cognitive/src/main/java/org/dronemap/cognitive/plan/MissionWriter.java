package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;

/** Writes a tour as the mission that its drone carries: all heights above sea level, but the take-off's. */
public final class MissionWriter {
    private static final double HIGHEST_TAKE_OFF_METERS = 500;
    private static final double LONGEST_HOLD_SECONDS = 3_600;

    private final Craft craft;
    private final boolean landsAnywhere;

    public MissionWriter(Craft craft, VehicleKind kind) {
        this.craft = craft;
        // An aeroplane needs its own way of coming down.
        this.landsAnywhere = kind != VehicleKind.FIXED_WING;
    }

    /**
     * A tour as a mission, which may have more items than one can hold.
     *
     * @param arrivals for each stop of the tour the number of the item, from 0, that is behind the drone when it is done
     */
    public record Written(List<MissionItem> items, List<Integer> arrivals) {
        public Written {
            items = List.copyOf(items);
            arrivals = List.copyOf(arrivals);
        }
    }

    /** Why no drone can carry it, as a sentence. */
    public Optional<String> fault(Tour tour) {
        int items = write(tour).items().size();
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

    public Written write(Tour tour) {
        List<MissionItem> items = new ArrayList<>();
        List<Integer> arrivals = new ArrayList<>();
        List<Way> ways = tour.ways();
        for (int number = 0; number < ways.size(); number++) {
            boolean last = number == ways.size() - 1;
            List<Fix> fixes = ways.get(number).fixes();
            int begin = number == 0 ? begin(items, fixes, last) : 1;
            int end = last && craft.lands() ? fixes.size() - 1 : fixes.size();
            for (int i = begin; i < end; i++) {
                boolean arrives = !last && i == fixes.size() - 1;
                items.add(waypoint(fixes.get(i).place(), arrives ? hold(tour, number) : 0));
            }
            if (!last) {
                arrivals.add(items.size() - 1);
            }
        }
        if (craft.lands()) {
            items.add(landsAnywhere ? new MissionItem.Land() : new MissionItem.ReturnToLaunch());
        }
        return new Written(items, arrivals);
    }

    /** With which fix it goes on after a take-off. */
    private int begin(List<MissionItem> items, List<Fix> fixes, boolean last) {
        if (!craft.takesOff()) {
            return 1;
        }
        takeOff(items, fixes.get(1).place());
        return last ? 2 : Math.min(2, fixes.size() - 1);
    }

    /** Until its next way begins: its task, and what waiting keeps drones apart. */
    private static double hold(Tour tour, int stop) {
        return Math.max(
                0, tour.way(stop + 1).departsSeconds() - tour.stops().get(stop).arrivesSeconds());
    }

    private void takeOff(List<MissionItem> items, Place top) {
        double height = top.altitudeAmslMeters() - craft.homeAmslMeters();
        double climbed = Math.max(1, Math.min(HIGHEST_TAKE_OFF_METERS, height));
        items.add(new MissionItem.TakeOff(climbed));
        if (climbed != height) {
            // Straight up all the same.
            items.add(waypoint(top, 0));
        }
    }

    private static MissionItem waypoint(Place place, double holdSeconds) {
        return new MissionItem.Waypoint(
                place.point(), new Altitude(place.altitudeAmslMeters(), Altitude.Reference.AMSL), holdSeconds);
    }
}
