package org.dronemap.cognitive.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.junit.jupiter.api.Test;

/** From places on the map to tours that can be flown. */
class FleetPlannerTest {
    private static final SearchBudget SHORT = SearchBudget.iterations(4_000);

    private static PlanningProblem problem(long seed, int waypoints, int crafts) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(
                    PlanningFixtures.waypoint(i, random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500)));
        }
        return PlanningProblem.of(places, PlanningFixtures.crafts(crafts));
    }

    @Test
    void plansToursThatTheIndependentCheckerFindsNoFaultIn() {
        for (int seed = 1; seed <= 20; seed++) {
            PlanResult planned = FleetPlanner.plan(problem(seed, 40, 1 + seed % 5), seed, SHORT, progress -> {});

            assertThat(planned.faults()).as("seed %d", seed).isEmpty();
            assertThat(planned.plan().unserved()).isEmpty();
        }
    }

    @Test
    void getsEarlierToTheEndWithMoreDrones() {
        double alone = FleetPlanner.plan(problem(7, 60, 1), 1, SHORT, progress -> {})
                .progress()
                .longestSeconds();
        double four = FleetPlanner.plan(problem(7, 60, 4), 1, SHORT, progress -> {})
                .progress()
                .longestSeconds();

        assertThat(four).isLessThan(alone / 2);
    }

    @Test
    void tellsHowFarItMayBeFromTheBest() {
        List<SearchProgress> heard = new ArrayList<>();
        PlanResult planned = FleetPlanner.plan(problem(3, 40, 1), 1, SHORT, heard::add);

        assertThat(heard).hasSizeGreaterThan(1);
        assertThat(heard)
                .extracting(SearchProgress::gap)
                .isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(planned.progress().gap()).isBetween(0.0, 0.1);
    }

    @Test
    void seesThatAnEndIsReachedWhereItIsPlanned() {
        PlanResult planned = FleetPlanner.plan(problem(5, 30, 3), 1, SHORT, progress -> {});

        double ends = planned.plan().tours().stream()
                .mapToDouble(Tour::endsSeconds)
                .max()
                .orElseThrow();
        assertThat(ends).isGreaterThanOrEqualTo(planned.progress().longestSeconds() - 1e-6);
    }

    @Test
    void givesTheSamePlanForTheSameSeedAndNumberOfIterations() {
        for (int seed = 1; seed <= 5; seed++) {
            PlanningProblem problem = problem(seed, 40, 3);

            assertThat(FleetPlanner.plan(problem, seed, SHORT, progress -> {}))
                    .isEqualTo(FleetPlanner.plan(problem, seed, SHORT, progress -> {}));
        }
    }
}
