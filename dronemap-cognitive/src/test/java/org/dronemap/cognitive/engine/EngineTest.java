package org.dronemap.cognitive.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.Scenes;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Waypoint;
import org.junit.jupiter.api.Test;

/** From places on the map to tours that can be flown. */
class EngineTest {
    private static final Budget SHORT = Budget.iterations(4_000);

    private static Problem problem(long seed, int waypoints, int crafts) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(Scenes.waypoint(i, random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500)));
        }
        return Problem.of(places, Scenes.crafts(crafts));
    }

    @Test
    void plansToursThatTheIndependentCheckerFindsNoFaultIn() {
        for (int seed = 1; seed <= 20; seed++) {
            Planned planned = Engine.plan(problem(seed, 40, 1 + seed % 5), seed, SHORT, progress -> {});

            assertThat(planned.faults()).as("seed %d", seed).isEmpty();
            assertThat(planned.plan().unserved()).isEmpty();
        }
    }

    @Test
    void getsEarlierToTheEndWithMoreDrones() {
        double alone = Engine.plan(problem(7, 60, 1), 1, SHORT, progress -> {})
                .progress()
                .longestSeconds();
        double four = Engine.plan(problem(7, 60, 4), 1, SHORT, progress -> {})
                .progress()
                .longestSeconds();

        assertThat(four).isLessThan(alone / 2);
    }

    @Test
    void tellsHowFarItMayBeFromTheBest() {
        List<Progress> heard = new ArrayList<>();
        Planned planned = Engine.plan(problem(3, 40, 1), 1, SHORT, heard::add);

        assertThat(heard).hasSizeGreaterThan(1);
        assertThat(heard).extracting(Progress::gap).isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(planned.progress().gap()).isBetween(0.0, 0.1);
    }

    @Test
    void seesThatAnEndIsReachedWhereItIsPlanned() {
        Planned planned = Engine.plan(problem(5, 30, 3), 1, SHORT, progress -> {});

        double ends = planned.plan().tours().stream()
                .mapToDouble(Tour::endsSeconds)
                .max()
                .orElseThrow();
        assertThat(ends).isGreaterThanOrEqualTo(planned.progress().longestSeconds() - 1e-6);
    }

    @Test
    void givesTheSamePlanForTheSameSeedAndNumberOfIterations() {
        for (int seed = 1; seed <= 5; seed++) {
            Problem problem = problem(seed, 40, 3);

            assertThat(Engine.plan(problem, seed, SHORT, progress -> {}))
                    .isEqualTo(Engine.plan(problem, seed, SHORT, progress -> {}));
        }
    }
}
