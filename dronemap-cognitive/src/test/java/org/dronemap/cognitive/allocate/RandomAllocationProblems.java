package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.cost.AllocationDrone;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.dronemap.cognitive.cost.AllocationWaypoint;

/** Problems drawn by a seed: two kinds of drones, windows, batteries, skills, priorities, depots that may differ. */
final class RandomAllocationProblems {
    private final SplittableRandom random;

    RandomAllocationProblems(long seed) {
        random = new SplittableRandom(seed);
    }

    AllocationProblem any(int waypoints, int drones) {
        return any(waypoints, drones, random.nextBoolean(), random.nextBoolean(), random.nextBoolean());
    }

    private AllocationProblem any(int waypoints, int drones, boolean windows, boolean batteries, boolean skills) {
        List<AllocationWaypoint> visits = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            BitSet able = new BitSet();
            for (int r = 0; r < drones; r++) {
                able.set(r, !skills || random.nextInt(4) > 0);
            }
            double opens = windows && random.nextBoolean() ? random.nextDouble(200) : 0;
            double closes = windows && random.nextBoolean() ? opens + random.nextDouble(150) : Double.POSITIVE_INFINITY;
            visits.add(new AllocationWaypoint(
                    random.nextInt(10), 1 + random.nextInt(3), 1 + random.nextInt(3), opens, closes, able));
        }
        List<AllocationDrone> carriers = new ArrayList<>();
        for (int r = 0; r < drones; r++) {
            double range = batteries ? 200 + random.nextDouble(900) : Double.POSITIVE_INFINITY;
            carriers.add(new AllocationDrone(random.nextInt(2), random.nextInt(3) * 10, range, random.nextInt(4) == 0));
        }
        return new AllocationProblem(legs(waypoints, drones), visits, carriers, aim());
    }

    /** Nothing but places. */
    AllocationProblem plain(int waypoints, int drones, AllocationObjective aim) {
        BitSet all = new BitSet();
        all.set(0, drones);
        AllocationWaypoint visit = new AllocationWaypoint(0, 0, 1, 0, Double.POSITIVE_INFINITY, all);
        AllocationDrone carrier = new AllocationDrone(0, 0, Double.POSITIVE_INFINITY);
        return new AllocationProblem(
                legs(waypoints, drones),
                Collections.nCopies(waypoints, visit),
                Collections.nCopies(drones, carrier),
                aim);
    }

    private PlanarLegs legs(int waypoints, int drones) {
        int places = waypoints + 2 * drones;
        double[] east = random.doubles(places, 0, 100).toArray();
        double[] north = random.doubles(places, 0, 100).toArray();
        for (int r = 0; r < drones; r++) {
            if (random.nextInt(4) > 0) {
                east[waypoints + 2 * r + 1] = east[waypoints + 2 * r];
                north[waypoints + 2 * r + 1] = north[waypoints + 2 * r];
            }
        }
        return new PlanarLegs(east, north, new double[] {1, 2}, random.nextBoolean() ? 0.3 : 0);
    }

    private AllocationObjective aim() {
        AllocationObjective.Measure measure = AllocationObjective.Measure.values()[random.nextInt(3)];
        AllocationObjective aim = switch (random.nextInt(3)) {
            case 0 -> AllocationObjective.minMax();
            case 1 -> AllocationObjective.minSum(measure);
            default -> new AllocationObjective(1, measure, 0.3, false);
        };
        return random.nextInt(4) == 0 ? aim.withEveryDrone() : aim;
    }
}
