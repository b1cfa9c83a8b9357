package org.dronemap.cognitive.follow;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.dronemap.core.separation.Separation;

/**
 * {@code FIRST COUNT SWARMS METERS HEIGHT}: flies so many random follows near fences from that seed on, on all cores, and so many
 * times three drones on one target and ten follows at once, which are to stay so far apart; tells how near it came.
 */
public final class RandomFollowStudy {
    private static final int EVERY = 250;
    private static final double THREE_SECONDS = 200;
    private static final double TEN_SECONDS = 120;

    /** What was flown, the least that was left over, and what went wrong, by seed. */
    record Summary(int flown, List<Worst> worst, List<String> failed) {}

    /** The least of one measure. */
    record Worst(String what, double meters, long seed) {}

    /** What one seed came to: least metres in the order of the names; negative or none left: it failed. */
    private record Flown(long seed, List<Double> meters) {}

    private RandomFollowStudy() {}

    public static void main(String[] words) {
        long first = Long.parseLong(words[0]);
        int count = Integer.parseInt(words[1]);
        int swarms = Integer.parseInt(words[2]);
        Separation apart = new Separation(Double.parseDouble(words[3]), Double.parseDouble(words[4]));
        List<Summary> tallies = new ArrayList<>();
        tallies.add(fenced(first, count));
        tell(System.out, "random follows near fences", tallies.get(0));
        tallies.add(swarms(first, swarms, apart));
        tell(
                System.out,
                String.format(
                        Locale.ROOT,
                        "times three on one target and ten at once, %.1f m or %.1f m in height apart",
                        apart.horizontalMeters(),
                        apart.verticalMeters()),
                tallies.get(1));
        System.exit(tallies.stream().allMatch(tally -> tally.failed().isEmpty()) ? 0 : 1);
    }

    /** Follows near fences and near the lowest height. */
    static Summary fenced(long first, int count) {
        return tally(first, count, List.of("to a fence", "above the lowest height"), seed -> {
            ZonedFollowFlight.Margins margins = ZonedFollowFlight.fly(seed);
            return List.of(margins.fenceMeters(), margins.heightMeters());
        });
    }

    /** Three on one target and ten at once; what is told is how much more than is to be kept they were apart. */
    static Summary swarms(long first, int count, Separation apart) {
        return tally(
                first,
                count,
                List.of("more than kept, three", "more than kept, ten", "above the lowest height"),
                seed -> {
                    MultiFollowTrial three = MultiFollowTrial.three(apart, seed, seed % 2 == 0);
                    MultiFollowTrial ten = MultiFollowTrial.ten(apart, seed);
                    return List.of(
                            three.fly(THREE_SECONDS) - apart.horizontalMeters(),
                            ten.fly(TEN_SECONDS) - apart.horizontalMeters(),
                            Math.min(three.lowest(), ten.lowest()) - FollowTrial.LOWEST_METERS);
                });
    }

    private static Summary tally(long first, int count, List<String> names, LongFunction<List<Double>> flight) {
        AtomicLong done = new AtomicLong();
        List<Flown> all = LongStream.range(first, first + count)
                .parallel()
                .mapToObj(seed -> {
                    Flown flown = new Flown(seed, flight.apply(seed));
                    if (done.incrementAndGet() % EVERY == 0) {
                        System.err.println(done.get() + " of " + count);
                    }
                    return flown;
                })
                .toList();
        List<Worst> worst = new ArrayList<>();
        List<String> failed = new ArrayList<>();
        for (int i = 0; i < names.size() && !all.isEmpty(); i++) {
            int measure = i;
            Flown least = all.stream()
                    .min(Comparator.comparing(flown -> flown.meters().get(measure)))
                    .orElseThrow();
            worst.add(new Worst(names.get(i), least.meters().get(measure), least.seed()));
            all.stream()
                    .filter(flown -> !(flown.meters().get(measure) > 0))
                    .forEach(flown -> failed.add(String.format(
                            Locale.ROOT,
                            "seed %d: %.2f m %s",
                            flown.seed(),
                            flown.meters().get(measure),
                            names.get(measure))));
        }
        return new Summary(all.size(), worst, failed);
    }

    private static void tell(PrintStream out, String what, Summary tally) {
        out.println(tally.flown() + " " + what + ": " + tally.failed().size() + " failed");
        for (Worst worst : tally.worst()) {
            out.printf(Locale.ROOT, "  least %.2f m %s (seed %d)%n", worst.meters(), worst.what(), worst.seed());
        }
        tally.failed().forEach(line -> out.println("  FAILED " + line));
    }
}
