package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class TourProblemTest {
    private static final List<String> LINES =
            List.of("metric euclidean", "aim longest", "depot 0 0", "depot 10 0", "waypoint 3 4", "waypoint 10 2.5");

    @Test
    void aProblemIsReadAsItStands() {
        TourProblem problem = TourProblemFile.of(LINES);

        assertThat(problem)
                .isEqualTo(new TourProblem(
                        Metric.EUCLIDEAN,
                        true,
                        List.of(new TourPoint(0, 0), new TourPoint(10, 0)),
                        List.of(new TourPoint(3, 4), new TourPoint(10, 2.5))));
    }

    @Test
    void aLineThatSaysNothingKnownIsRefused() {
        assertThatThrownBy(() -> TourProblemFile.of(List.of("name att532")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'name'");
    }

    @Test
    void toursBeginAndEndAtTheirDepots() {
        TourProblem problem = TourProblemFile.of(LINES);

        assertThat(problem.length(0, new int[] {0})).isEqualTo(10);
        assertThat(problem.length(1, new int[] {1})).isEqualTo(5);
        assertThat(problem.length(1, new int[0])).isZero();
    }

    @Test
    void theLongestTourOrTheSumCounts() {
        int[][] orders = {{0}, {1}};
        TourProblem longest = TourProblemFile.of(LINES);
        TourProblem sum = new TourProblem(longest.metric(), false, longest.depots(), longest.waypoints());

        assertThat(longest.value(orders)).isEqualTo(10);
        assertThat(sum.value(orders)).isEqualTo(15);
    }

    @Test
    void attDistancesAreATenthOfTheSquareRoundedUp() {
        assertThat(Metric.ATT.between(new TourPoint(0, 0), new TourPoint(30, 40))).isEqualTo(16);
        assertThat(Metric.EUCLIDEAN.between(new TourPoint(0, 0), new TourPoint(30, 40))).isEqualTo(50);
    }

    @Test
    void ourLegsAreTheProblemsDistances() {
        TourProblem problem = new RandomTourProblems(3).next(true, 30);
        StraightLegs legs = new StraightLegs(problem);
        int waypoints = problem.waypoints().size();

        assertThat(legs.places()).isEqualTo(waypoints + 2 * problem.drones());
        for (int drone = 0; drone < problem.drones(); drone++) {
            for (int waypoint = 0; waypoint < waypoints; waypoint++) {
                double there = problem.distance(problem.depot(drone), waypoint);
                assertThat(legs.seconds(0, waypoints + 2 * drone, waypoint)).isEqualTo(there);
                assertThat(legs.seconds(0, waypoint, waypoints + 2 * drone + 1)).isEqualTo(there);
            }
        }
    }
}
