package org.dronemap.cognitive.follow;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.LongFunction;
import org.dronemap.cognitive.follow.FollowTrial.Noise;
import org.dronemap.cognitive.follow.FollowTrial.Result;
import org.dronemap.cognitive.follow.FollowTrial.Setup;
import org.dronemap.cognitive.follow.FollowTrial.Way;

/**
 * {@code BINARY SEEDS}: has real ArduCopters follow the walkers and the cyclists of {@link FollowExperiment} over its slow link, as fast
 * as life and many at a time, and writes a line of JSON for each kind. The cyclists are followed twice: by some that lean as far
 * as they are delivered, and by some that may lean farther.
 */
public final class SitlExperiment {
    private static final double DELIVERED = 30;
    private static final List<Kind> KINDS = List.of(
            new Kind(TargetPath::walking, DELIVERED),
            new Kind(TargetPath::cycling, DELIVERED),
            new Kind(TargetPath::cycling, 45));
    private static final int AT_A_TIME = 20;

    /** {@code lean}: how far they may at most, in degrees. */
    private record Kind(LongFunction<TargetPath> walk, double lean) {}

    private record Flown(String vehicle, Result result) {}

    private SitlExperiment() {}

    public static void main(String[] words) throws InterruptedException, ExecutionException {
        Path binary = Path.of(words[0]);
        int seeds = Integer.parseInt(words[1]);
        ExecutorService each = Executors.newFixedThreadPool(AT_A_TIME);
        try {
            List<List<Future<Flown>>> all = new ArrayList<>();
            for (Kind kind : KINDS) {
                List<Future<Flown>> flights = new ArrayList<>();
                for (int seed = 1; seed <= seeds; seed++) {
                    int number = seed;
                    flights.add(each.submit(() -> fly(binary, kind, number)));
                }
                all.add(flights);
            }
            for (int kind = 0; kind < KINDS.size(); kind++) {
                String walk = KINDS.get(kind).walk().apply(1).name();
                System.out.println(line(walk, all.get(kind)).json());
            }
        } finally {
            each.shutdownNow();
        }
    }

    private static Flown fly(Path binary, Kind kind, long seed) {
        Setup setup = new Setup(
                Way.FORESEEN,
                FollowExperiment.SOUTH,
                Noise.NONE,
                FollowExperiment.SLOW.quality(),
                FollowExperiment.WIND,
                seed,
                FollowExperiment.SETTLED);
        try (SitlDrone drone = new SitlDrone(binary, kind.lean(), FollowTrial.height(setup), setup.wind(), seed)) {
            String leans =
                    kind.lean() == DELIVERED ? "" : String.format(Locale.ROOT, ", leaning up to %.0f°", kind.lean());
            return new Flown(drone.name() + leans, FollowTrial.fly(kind.walk().apply(seed), setup, drone));
        }
    }

    private static ExperimentRow line(String walk, List<Future<Flown>> flights)
            throws InterruptedException, ExecutionException {
        List<Result> results = new ArrayList<>();
        String vehicle = "";
        for (Future<Flown> flight : flights) {
            vehicle = flight.get().vehicle();
            results.add(flight.get().result());
        }
        return new ExperimentRow(
                vehicle,
                walk,
                FollowExperiment.SLOW.name(),
                Noise.NONE,
                Way.FORESEEN,
                FollowExperiment.SETTLED,
                results);
    }
}
