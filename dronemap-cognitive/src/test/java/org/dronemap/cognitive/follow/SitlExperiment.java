package org.dronemap.cognitive.follow;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.LongFunction;
import org.dronemap.cognitive.follow.Trial.Noise;
import org.dronemap.cognitive.follow.Trial.Result;
import org.dronemap.cognitive.follow.Trial.Setup;
import org.dronemap.cognitive.follow.Trial.Way;

/**
 * {@code BINARY SEEDS}: has real ArduCopters follow the walkers and the cyclists of {@link Experiment} over its slow link, as fast
 * as life and many at a time, and writes a line of JSON for each kind.
 */
public final class SitlExperiment {
    private static final List<LongFunction<Walk>> WALKS = List.of(Walk::walking, Walk::cycling);
    private static final int AT_A_TIME = 20;

    private record Flown(String vehicle, Result result) {}

    private SitlExperiment() {}

    public static void main(String[] words) throws InterruptedException, ExecutionException {
        Path binary = Path.of(words[0]);
        int seeds = Integer.parseInt(words[1]);
        ExecutorService each = Executors.newFixedThreadPool(AT_A_TIME);
        try {
            List<List<Future<Flown>>> all = new ArrayList<>();
            for (LongFunction<Walk> walk : WALKS) {
                List<Future<Flown>> flights = new ArrayList<>();
                for (int seed = 1; seed <= seeds; seed++) {
                    int number = seed;
                    flights.add(each.submit(() -> fly(binary, walk.apply(number), number)));
                }
                all.add(flights);
            }
            for (int kind = 0; kind < WALKS.size(); kind++) {
                String walk = WALKS.get(kind).apply(1).name();
                System.out.println(line(walk, all.get(kind)).json());
            }
        } finally {
            each.shutdownNow();
        }
    }

    private static Flown fly(Path binary, Walk walk, long seed) {
        Setup setup = new Setup(
                Way.FORESEEN,
                Experiment.SOUTH,
                Noise.NONE,
                Experiment.SLOW.quality(),
                Experiment.WIND,
                seed,
                Experiment.SETTLED);
        try (SitlDrone drone = new SitlDrone(binary, Trial.height(setup), setup.wind(), seed)) {
            return new Flown(drone.name(), Trial.fly(walk, setup, drone));
        }
    }

    private static Line line(String walk, List<Future<Flown>> flights) throws InterruptedException, ExecutionException {
        List<Result> results = new ArrayList<>();
        String vehicle = "";
        for (Future<Flown> flight : flights) {
            vehicle = flight.get().vehicle();
            results.add(flight.get().result());
        }
        return new Line(vehicle, walk, Experiment.SLOW.name(), Noise.NONE, Way.FORESEEN, Experiment.SETTLED, results);
    }
}
