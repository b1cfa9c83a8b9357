package org.dronemap.bench.planning.loss;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.cognitive.replan.LiveAssignment;
import org.dronemap.cognitive.replan.ReplanSituation;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;

/** Draws a mission, flies it to a random moment and loses a random drone. */
final class DroneLossScenario {
    private static final double GROUND_METERS = 400;
    private static final double FLIGHT_METERS = 450;
    private static final double METERS_PER_DEGREE = 111_200;
    private static final double LATITUDE = 47;
    private static final double LONGITUDE = 8;
    private static final long ITERATIONS_PER_WAYPOINT = 200;
    private static final long MOST_ITERATIONS = 100_000;

    private final SplittableRandom random;
    private final double extentMeters;

    private DroneLossScenario(long seed, int waypoints) {
        random = new SplittableRandom(seed);
        extentMeters = 200 * Math.sqrt(waypoints);
    }

    static ReplanSituation of(long seed, int waypoints, int drones) {
        DroneLossScenario loss = new DroneLossScenario(seed, waypoints);
        PlanningProblem problem = loss.problem(waypoints, drones);
        long iterations = Math.min(MOST_ITERATIONS, ITERATIONS_PER_WAYPOINT * waypoints);
        List<Tour> tours = FleetPlanner.plan(problem, seed, SearchBudget.iterations(iterations), better -> {})
                .plan()
                .tours();
        return loss.situation(problem, tours);
    }

    private PlanningProblem problem(int waypoints, int drones) {
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(Waypoint.at("w" + i, place(FLIGHT_METERS)));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int r = 0; r < drones; r++) {
            crafts.add(
                    Craft.atHome(new DroneId("d" + r), place(GROUND_METERS), Performance.of(VehicleKind.MULTICOPTER)));
        }
        return PlanningProblem.of(places, crafts);
    }

    private Place place(double altitude) {
        double north = random.nextDouble(extentMeters) / METERS_PER_DEGREE;
        double east = random.nextDouble(extentMeters) / METERS_PER_DEGREE / Math.cos(Math.toRadians(LATITUDE));
        return new Place(new Geodetic(LATITUDE + north, LONGITUDE + east), altitude);
    }

    private ReplanSituation situation(PlanningProblem problem, List<Tour> tours) {
        double ends = tours.stream().mapToDouble(Tour::endsSeconds).max().orElse(0);
        double now = ends * random.nextDouble(0.05, 0.4);
        DroneId lost =
                problem.crafts().get(random.nextInt(problem.crafts().size())).id();
        Set<String> done = new HashSet<>();
        List<LiveAssignment> live = new ArrayList<>();
        Map<DroneId, Start> starts = new HashMap<>();
        for (Tour tour : tours) {
            List<String> left = new ArrayList<>();
            for (TourStop stop : tour.stops()) {
                if (stop.arrivesSeconds() <= now) {
                    done.add(stop.waypoint());
                } else {
                    left.add(stop.waypoint());
                }
            }
            int first = left.isEmpty() || tour.drone().equals(lost) ? 0 : 1;
            live.add(new LiveAssignment(tour.drone(), left.subList(0, first), left.subList(first, left.size())));
            starts.put(tour.drone(), start(tour, now));
        }
        List<Craft> crafts = problem.crafts().stream()
                .filter(craft -> !craft.id().equals(lost))
                .map(craft -> craft.with(starts.getOrDefault(craft.id(), craft.start())))
                .toList();
        List<Waypoint> open = problem.waypoints().stream()
                .filter(waypoint -> !done.contains(waypoint.id()))
                .toList();
        return new ReplanSituation(PlanningProblem.of(open, crafts), live);
    }

    private static Start start(Tour tour, double now) {
        Place place = place(tour, now);
        boolean onGround = now <= tour.departsSeconds() || now >= tour.endsSeconds();
        return onGround ? Start.onGround(place) : Start.inFlight(place);
    }

    /** Between two fixes at constant speed. */
    private static Place place(Tour tour, double now) {
        Place place = tour.way(0).from();
        for (TourLeg way : tour.ways()) {
            for (int i = 0; i + 1 < way.fixes().size(); i++) {
                TimedPlace one = way.fixes().get(i);
                TimedPlace next = way.fixes().get(i + 1);
                if (now >= next.seconds()) {
                    place = next.place();
                } else if (now > one.seconds()) {
                    return between(one.place(), next.place(), (now - one.seconds()) / (next.seconds() - one.seconds()));
                }
            }
        }
        return place;
    }

    private static Place between(Place one, Place next, double share) {
        return new Place(
                new Geodetic(
                        mix(one.point().latitudeDegrees(), next.point().latitudeDegrees(), share),
                        mix(one.point().longitudeDegrees(), next.point().longitudeDegrees(), share)),
                mix(one.altitudeAmslMeters(), next.altitudeAmslMeters(), share));
    }

    private static double mix(double one, double next, double share) {
        return one + share * (next - one);
    }
}
