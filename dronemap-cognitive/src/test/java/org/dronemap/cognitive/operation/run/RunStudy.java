package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;

/**
 * Many random runs with random failures in virtual time, for {@code bench/plan study}: one line for each seed, with what was
 * visited, how long it took with and without the failures, and how long waypoints were nobody's.
 */
public final class RunStudy {
    private RunStudy() {}

    /** The first seed, and how many. */
    public static void main(String[] args) {
        long first = Long.parseLong(args[0]);
        LongStream.range(first, first + Long.parseLong(args[1]))
                .parallel()
                .mapToObj(RunStudy::line)
                .forEach(System.out::println);
    }

    private static String line(long seed) {
        try {
            RunTestBench calm = RandomRunsTest.undisturbed(new SplittableRandom(seed), seed);
            calm.flyToTheEnd();
            RunTestBench fleet = RandomRunsTest.disturbed(seed);
            fleet.flyToTheEnd();
            return told(seed, calm, fleet);
        } catch (AssertionError broken) {
            return "broken " + seed + " " + broken.getMessage().replaceAll("\\s+", " ");
        }
    }

    private static String told(long seed, RunTestBench calm, RunTestBench fleet) {
        long lost = fleet.vehicles.values().stream()
                .filter(vehicle -> vehicle.fallen || vehicle.cut)
                .count();
        boolean somebodyLeft = fleet.state.drones().stream().anyMatch(drone -> drone.stage() == RunDroneStage.LANDED);
        return String.format(
                Locale.ROOT,
                "run %d %d %d %d %d %d %b %.2f %.2f %.2f %s",
                seed,
                fleet.vehicles.size(),
                lost,
                fleet.state.targets().size(),
                fleet.state.count(RunWaypoint.State.VISITED),
                fleet.state.counts().replans(),
                somebodyLeft,
                seconds(calm),
                seconds(fleet),
                Math.min(fleet.closest, 1_000),
                waits(fleet).stream().map(Object::toString).collect(Collectors.joining(",", "[", "]")));
    }

    private static double seconds(RunTestBench fleet) {
        Instant end = fleet.journal.get(fleet.journal.size() - 1).at();
        return Duration.between(RunTestBench.START, end).toMillis() / 1_000.0;
    }

    /** How long each waypoint that had lost its drone waited until another one had it on board, in seconds. */
    private static List<Double> waits(RunTestBench fleet) {
        Map<String, Instant> orphans = new HashMap<>();
        List<Double> waits = new ArrayList<>();
        RunState before = fleet.first;
        for (int i = 0; i < fleet.journal.size(); i++) {
            Instant now = fleet.journal.get(i).at();
            RunState after = fleet.decisions.get(i).next();
            for (RunWaypoint target : after.targets()) {
                boolean owned = before.target(target.id())
                        .filter(old -> old.drone() != null)
                        .isPresent();
                if (owned && target.state() == RunWaypoint.State.WAITING) {
                    orphans.putIfAbsent(target.id(), now);
                } else if (target.state().isSettled() || isOnBoard(after, target)) {
                    Instant since = orphans.remove(target.id());
                    if (since != null && target.state() != RunWaypoint.State.UNSERVED) {
                        waits.add(Duration.between(since, now).toMillis() / 1_000.0);
                    }
                }
            }
            before = after;
        }
        return waits;
    }

    private static boolean isOnBoard(RunState state, RunWaypoint target) {
        return state.drones().stream()
                .filter(drone -> drone.id().equals(target.drone()) && drone.stage() == RunDroneStage.FLYING)
                .anyMatch(drone -> drone.sortie() != null && drone.sortie().leadsTo(target.id(), drone.passed()));
    }
}
