package org.dronemap.bench.planning;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;

/**
 * {@code PLACES-FILE SEED CPU-SECONDS WARM-UP-SECONDS}: plans places on the ground without any server. The file has lines
 * {@code drone LATITUDE LONGITUDE AMSL} and {@code waypoint LATITUDE LONGITUDE AMSL}. Writes {@code seconds}: when the last
 * drone is back.
 */
public final class OfflinePlanning {
    private static final int ARGUMENTS = 4;

    private OfflinePlanning() {}

    public static void main(String[] words) throws IOException {
        run(words, System.out);
    }

    static void run(String[] words, PrintStream out) throws IOException {
        if (words.length != ARGUMENTS) {
            throw new IllegalArgumentException("wants PLACES-FILE SEED CPU-SECONDS WARM-UP-SECONDS");
        }
        PlanningProblem problem = read(Path.of(words[0]));
        long seed = Long.parseLong(words[1]);
        search(problem, seed + 1, Double.parseDouble(words[3]));
        out.println("seconds " + search(problem, seed, Double.parseDouble(words[2])));
    }

    private static double search(PlanningProblem problem, long seed, double cpuSeconds) {
        CpuBudget allowance = CpuBudget.fromNow(cpuSeconds);
        SearchBudget budget = iterations -> allowance.share();
        return FleetPlanner.plan(problem, seed, budget, better -> {}).progress().longestSeconds();
    }

    private static PlanningProblem read(Path file) throws IOException {
        List<Craft> crafts = new ArrayList<>();
        List<Waypoint> waypoints = new ArrayList<>();
        for (String line : Files.readAllLines(file)) {
            String[] words = line.split(" ", -1);
            Place place = new Place(
                    new Geodetic(Double.parseDouble(words[1]), Double.parseDouble(words[2])),
                    Double.parseDouble(words[3]));
            if (words[0].equals("drone")) {
                crafts.add(Craft.atHome(
                        new DroneId("d" + crafts.size()), place, Performance.of(VehicleKind.MULTICOPTER, "ArduPilot")));
            } else {
                waypoints.add(Waypoint.at(String.valueOf(waypoints.size()), place));
            }
        }
        return PlanningProblem.of(waypoints, crafts);
    }
}
