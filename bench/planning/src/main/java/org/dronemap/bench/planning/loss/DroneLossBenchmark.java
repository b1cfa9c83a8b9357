package org.dronemap.bench.planning.loss;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.LongStream;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.cognitive.replan.ReplanSituation;
import org.dronemap.cognitive.replan.Replanner;

/**
 * {@code CASES WAYPOINTS DRONES BUDGET-MILLIS SOLVE-SECONDS}: re-plans so many missions that lose a drone, one after the
 * other, with two searches at the same time as on a server with two processors, and holds each against a long search from
 * the same situation (two at a time; none for 0 seconds).
 * Writes a line for each: {@code case AT-ONCE-MS BETTER-MS FAULTS AT-ONCE-COST BETTER-COST LONG-COST CHANGED}. Both times
 * count from the situation to the checked plan, the better one's to the budget's end and what comes after.
 */
public final class DroneLossBenchmark {
    private static final int ARGUMENTS = 5;
    private static final int WARM_UP_CASES = 60;
    private static final int MOST_WARM_UP_WAYPOINTS = 2_000;
    private static final int WARM_UP_SEED = 1_000_000;
    private static final double NANOS_PER_MILLI = 1e6;
    private static final int SEARCHES = 2;
    /** What building the problem and writing the plan take of the budget. */
    private static final double SEARCH_SHARE = 0.95;

    private DroneLossBenchmark() {}

    private record Measured(
            Replanner replanning, double onceMillis, double betterMillis, ReplanResult once, ReplanResult better) {}

    public static void main(String[] words) {
        if (words.length != ARGUMENTS) {
            throw new IllegalArgumentException("wants CASES WAYPOINTS DRONES BUDGET-MILLIS SOLVE-SECONDS");
        }
        int cases = Integer.parseInt(words[0]);
        int waypoints = Integer.parseInt(words[1]);
        int drones = Integer.parseInt(words[2]);
        double budgetMillis = Double.parseDouble(words[3]);
        Duration solve = Duration.ofMillis((long) (1_000 * Double.parseDouble(words[4])));
        warmUp(waypoints, drones, budgetMillis);
        List<ReplanSituation> situations = LongStream.range(0, cases)
                .mapToObj(seed -> DroneLossScenario.of(seed, waypoints, drones))
                .toList();
        List<Measured> measured = situations.stream()
                .map(situation -> measure(situation, budgetMillis))
                .toList();
        measured.stream().parallel().map(one -> line(one, solve)).forEachOrdered(System.out::println);
    }

    private static void warmUp(int waypoints, int drones, double budgetMillis) {
        int count = waypoints > MOST_WARM_UP_WAYPOINTS ? 2 : WARM_UP_CASES;
        for (int i = 0; i < count; i++) {
            measure(DroneLossScenario.of(WARM_UP_SEED + i, Math.min(waypoints, MOST_WARM_UP_WAYPOINTS), drones), budgetMillis);
        }
    }

    private static Measured measure(ReplanSituation situation, double budgetMillis) {
        long began = System.nanoTime();
        Replanner replanning = FleetPlanner.replanning(situation);
        ReplanResult once = replanning.atOnce();
        double onceMillis = (System.nanoTime() - began) / NANOS_PER_MILLI;
        SearchBudget budget = iterations -> (System.nanoTime() - began) / NANOS_PER_MILLI / (SEARCH_SHARE * budgetMillis);
        ReplanResult better = replanning.improve(1, budget, SEARCHES, ForkJoinPool.commonPool());
        double betterMillis = (System.nanoTime() - began) / NANOS_PER_MILLI;
        return new Measured(replanning, onceMillis, betterMillis, once, better);
    }

    private static String line(Measured measured, Duration solve) {
        double best = solve.isZero()
                ? measured.better().after().cost()
                : measured.replanning()
                        .improve(2, SearchBudget.time(solve, System::nanoTime))
                        .after()
                        .cost();
        return String.format(
                Locale.ROOT,
                "case %.3f %.3f %d %.4f %.4f %.4f %d",
                measured.onceMillis(),
                measured.betterMillis(),
                measured.once().faults().size() + measured.better().faults().size(),
                measured.once().after().cost(),
                measured.better().after().cost(),
                best,
                measured.better().changes().drones().size());
    }
}
