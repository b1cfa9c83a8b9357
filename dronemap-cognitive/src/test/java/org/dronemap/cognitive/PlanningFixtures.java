package org.dronemap.cognitive;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Power;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.cognitive.problem.WindResponse;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;

/** Places near 47 N 8 E, and drones with round figures. */
public final class PlanningFixtures {
    public static final double LATITUDE = 47;
    public static final double LONGITUDE = 8;
    /** On WGS-84 at 47 N. */
    public static final double METERS_PER_DEGREE_EAST = 76_056.2;

    public static final double METERS_PER_DEGREE_NORTH = 111_170.2;

    private PlanningFixtures() {}

    public static Geodetic point(double eastMeters, double northMeters) {
        return new Geodetic(
                LATITUDE + northMeters / METERS_PER_DEGREE_NORTH, LONGITUDE + eastMeters / METERS_PER_DEGREE_EAST);
    }

    public static Place place(double eastMeters, double northMeters, double altitude) {
        return new Place(point(eastMeters, northMeters), altitude);
    }

    /** 10 m/s, up 2, down 1, the last 10 m with 0.5; no time to gather speed; hovers at 100 W, cruises 150, climbs 200. */
    public static Performance copter() {
        return new Performance(
                new Speeds(10, 2, 1, 0.5, 15, Double.POSITIVE_INFINITY),
                new Power(100, 150, 200),
                WindResponse.KEEPS_GROUND_SPEED);
    }

    public static Performance aeroplane() {
        return new Performance(
                new Speeds(10, 2, 1, 0.5, 15, Double.POSITIVE_INFINITY),
                new Power(100, 150, 200),
                WindResponse.KEEPS_AIRSPEED);
    }

    public static Craft craft(int number, double east, double north) {
        return Craft.atHome(new DroneId("d" + number), place(east, north, 400), copter());
    }

    public static Waypoint waypoint(int number, double east, double north) {
        return Waypoint.at("w" + number, place(east, north, 450));
    }

    public static List<Waypoint> waypoints(double[]... spots) {
        List<Waypoint> waypoints = new ArrayList<>();
        for (double[] spot : spots) {
            waypoints.add(waypoint(waypoints.size(), spot[0], spot[1]));
        }
        return waypoints;
    }

    public static List<Craft> crafts(int count) {
        return IntStream.range(0, count).mapToObj(i -> craft(i, 80.0 * i, 0)).toList();
    }
}
