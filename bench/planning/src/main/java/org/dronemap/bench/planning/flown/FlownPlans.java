package org.dronemap.bench.planning.flown;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.dronemap.bench.planning.flown.SimulatedTestFlight.FlightEffort;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.PlanningRules;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.WindModel;

/**
 * {@code FIRST-SEED CASES}: so many random plans with wind, heights and fences, each tour flown by a simulated copter in
 * virtual time; planned with figures that were measured of that copter, and with those that its kind has as its autopilot is delivered.
 * Writes a line for each tour: {@code flown SEED measured|assumed WIND FENCES STOPS PLANNED-S FLOWN-S PLANNED-J FLOWN-J}.
 */
public final class FlownPlans {
    private static final LocalFrame HOME = new LocalFrame(47.3977, 8.5456, 488);
    private static final double FIELD = 350;
    private static final double SPACING = 60;
    private static final double LOWEST = 20;
    private static final double HIGHEST = 80;
    private static final double STRONGEST_WIND = 8;
    private static final int ITERATIONS = 3_000;

    private FlownPlans() {}

    public static void main(String[] words) {
        long first = Long.parseLong(words[0]);
        Performance measured = new PerformanceMeasurement(HOME).performance();
        System.out.println("about " + measured);
        LongStream.range(first, first + Long.parseLong(words[1])).parallel().forEach(seed -> {
            fly(seed, "measured", measured);
            fly(seed, "assumed", Performance.of(VehicleKind.MULTICOPTER, "ArduPilot"));
        });
    }

    private static void fly(long seed, String figures, Performance performance) {
        SplittableRandom random = new SplittableRandom(seed);
        double speed = random.nextDouble(0, STRONGEST_WIND);
        double towards = random.nextDouble(0, 2 * Math.PI);
        double from = (Math.toDegrees(towards) + 180) % 360;
        PlanningProblem problem = problem(random, performance, new org.dronemap.cognitive.problem.UniformWind(speed, from));
        PlanResult planned = FleetPlanner.plan(problem, seed, SearchBudget.iterations(ITERATIONS), progress -> {});
        if (!planned.canBeFlown()) {
            throw new IllegalStateException("seed " + seed + ": " + planned.faults());
        }
        for (int drone = 0; drone < problem.crafts().size(); drone++) {
            Tour tour = planned.plan().tours().get(drone);
            if (!tour.stops().isEmpty()) {
                LocalFrame home = HOME.shifted(new NeuPosition(0, SPACING * drone, 0));
                MissionWriter writer =
                        new MissionWriter(problem.crafts().get(drone), VehicleKind.MULTICOPTER, id -> Task.FLY_THROUGH);
                FlightEffort flown = new SimulatedTestFlight(home, new WindModel(speed, towards, seed))
                        .fly(writer.write(tour).items());
                System.out.println(String.format(
                        Locale.ROOT,
                        "flown %d %s %.2f %d %d %.2f %.2f %.0f %.0f",
                        seed,
                        figures,
                        speed,
                        problem.barriers().size(),
                        tour.stops().size(),
                        tour.endsSeconds() - tour.departsSeconds(),
                        flown.seconds(),
                        tour.usedJoules(),
                        flown.joules()));
            }
        }
    }

    private static PlanningProblem problem(
            SplittableRandom random, Performance performance, org.dronemap.cognitive.problem.UniformWind wind) {
        List<Barrier> barriers = new ArrayList<>();
        for (int i = random.nextInt(5); i > 0; i--) {
            Place middle = place(random.nextDouble(-FIELD, FIELD), random.nextDouble(120, 2 * FIELD), 0);
            double ceiling = HOME.altitudeAmsl() + random.nextDouble(LOWEST, HIGHEST);
            AltitudeBand band = random.nextBoolean()
                    ? AltitudeBand.ALL
                    : new AltitudeBand(null, ceiling, org.dronemap.core.mission.Altitude.Reference.AMSL);
            FenceArea.Circle circle = new FenceArea.Circle(false, middle.point(), random.nextDouble(20, 60));
            barriers.add(new Barrier("zone " + i, circle, band, Set.of()));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int i = random.nextInt(1, 4); i > 0; i--) {
            Place stand = place(SPACING * crafts.size(), 0, 0);
            crafts.add(Craft.atHome(new DroneId("d" + crafts.size()), stand, performance));
        }
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = random.nextInt(5, 25); i > 0; i--) {
            Place there = place(
                    random.nextDouble(-FIELD, FIELD),
                    random.nextDouble(0, 2 * FIELD),
                    random.nextDouble(LOWEST, HIGHEST));
            Task task = random.nextInt(4) == 0 ? new Task(random.nextInt(3, 20), Set.of()) : Task.FLY_THROUGH;
            waypoints.add(new Waypoint("w" + i, there, task, 1, TimeWindow.ALWAYS));
        }
        return new PlanningProblem(waypoints, crafts, barriers, wind, Objective.earliestEnd(), PlanningRules.USUAL);
    }

    private static Place place(double east, double north, double up) {
        NeuPosition there = new NeuPosition(north, east, up);
        return new Place(new Geodetic(HOME.latitudeOf(there), HOME.longitudeOf(there)), HOME.altitudeAmsl() + up);
    }
}
