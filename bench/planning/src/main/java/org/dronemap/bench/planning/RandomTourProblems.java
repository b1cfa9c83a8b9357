package org.dronemap.bench.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Problems for warming up: drawn by a seed, of many sizes, none of any data set. */
final class RandomTourProblems {
    private final SplittableRandom random;

    RandomTourProblems(long seed) {
        random = new SplittableRandom(seed);
    }

    TourProblem next(boolean longest, int mostWaypoints) {
        int waypoints = 20 + random.nextInt(mostWaypoints);
        int drones = 2 + random.nextInt(9);
        boolean oneDepot = random.nextBoolean();
        List<TourPoint> depots = new ArrayList<>();
        for (int r = 0; r < drones; r++) {
            depots.add(oneDepot && r > 0 ? depots.get(0) : spot());
        }
        List<TourPoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(spot());
        }
        return new TourProblem(Metric.EUCLIDEAN, longest, depots, places);
    }

    private TourPoint spot() {
        return new TourPoint(1000 * random.nextDouble(), 1000 * random.nextDouble());
    }
}
