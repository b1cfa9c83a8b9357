package org.dronemap.core.virtual;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;

/**
 * Divides a virtual drone's mission into shares, one for each drone: its waypoints in their order, so that the longest
 * flight, with the ways out and home, is as short as it can be. More drones than shorten it are not used. Only the last
 * share ends as the mission does; from the others the drones come home.
 */
public final class MissionShares {
    /** For less than this of the longest flight no further drone is sent up. */
    private static final double LEAST_GAIN = 0.05;
    /** At which waiting at a waypoint counts as way. */
    private static final double METERS_PER_SECOND = 5;

    private static final int MOST_HALVINGS = 50;

    private final VirtualTour tour;
    private final double[] fromHome;
    /** Up to each waypoint from the first one, in metres, with what is waited before it. */
    private final double[] along;

    private MissionShares(VirtualTour tour, Geodetic home) {
        this.tour = tour;
        List<MissionItem.Waypoint> waypoints = tour.waypoints();
        this.fromHome = new double[waypoints.size()];
        this.along = new double[waypoints.size()];
        double meters = 0;
        for (int i = 0; i < fromHome.length; i++) {
            Geodetic place = waypoints.get(i).point();
            fromHome[i] = Geodesy.distanceMeters(home, place);
            if (i > 0) {
                meters += Geodesy.distanceMeters(waypoints.get(i - 1).point(), place) + waiting(i - 1);
            }
            along[i] = meters;
        }
    }

    /** {@code home}: about where the drones begin. At most {@code most} shares, at least one. */
    public static List<Mission> of(Mission mission, Geodetic home, int most) {
        MissionShares shares = new MissionShares(VirtualTour.of(mission), home);
        int useful = shares.starts(shares.shortest(most) * (1 + LEAST_GAIN)).size();
        return useful == 1 ? List.of(mission) : shares.missions(shares.starts(shares.shortest(useful)));
    }

    /** The longest flight of so many drones at most, in metres. */
    private double shortest(int most) {
        double low = 0;
        for (int i = 0; i < along.length; i++) {
            low = Math.max(low, flight(i, i));
        }
        double high = Math.max(low, flight(0, along.length - 1));
        if (starts(low).size() <= most) {
            return low;
        }
        for (int i = 0; i < MOST_HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (starts(middle).size() <= most) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    /** The first waypoint of each share when no flight may be longer. */
    private List<Integer> starts(double longest) {
        List<Integer> starts = new ArrayList<>(List.of(0));
        int start = 0;
        for (int i = 1; i < along.length; i++) {
            if (flight(start, i) > longest) {
                start = i;
                starts.add(i);
            }
        }
        return starts;
    }

    /** Metres out, over the waypoints from the first to the last of them, and home. */
    private double flight(int first, int last) {
        boolean comesHome = !tour.landsThere() || last < along.length - 1;
        return fromHome[first] + along[last] - along[first] + waiting(last) + (comesHome ? fromHome[last] : 0);
    }

    private double waiting(int waypoint) {
        return tour.waypoints().get(waypoint).holdSeconds() * METERS_PER_SECOND;
    }

    private List<Mission> missions(List<Integer> starts) {
        List<Mission> missions = new ArrayList<>();
        for (int share = 0; share < starts.size(); share++) {
            boolean last = share == starts.size() - 1;
            missions.add(mission(starts.get(share), last ? along.length : starts.get(share + 1)));
        }
        return List.copyOf(missions);
    }

    private Mission mission(int first, int end) {
        List<MissionItem> items = new ArrayList<>();
        Double takeOff = tour.takeOffMeters();
        if (takeOff != null) {
            items.add(new MissionItem.TakeOff(takeOff));
        }
        items.addAll(tour.waypoints().subList(first, end));
        boolean lands = tour.landsThere() && end == along.length;
        items.add(lands ? new MissionItem.Land() : new MissionItem.ReturnToLaunch());
        return new Mission(items);
    }
}
