package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ConvergenceTest {
    private static TourProblem problem(boolean longest) {
        return new TourProblem(
                Metric.EUCLIDEAN,
                longest,
                List.of(new TourPoint(0, 0), new TourPoint(0, 0)),
                List.of(new TourPoint(1, 0), new TourPoint(2, 0), new TourPoint(-2, 0)));
    }

    @Test
    void onlyBetterToursAreNoted() {
        Convergence convergence = new Convergence(problem(true), CpuBudget.fromNow(1));

        convergence.accept(new int[][] {{0, 1, 2}, {}});
        convergence.accept(new int[][] {{2, 0, 1}, {}});
        convergence.accept(new int[][] {{0, 1}, {2}});

        assertThat(convergence.points()).extracting(Convergence.Point::value).containsExactly(8.0, 4.0);
    }

    @Test
    void toursThatLeaveADroneIdleOrAWaypointOutAreNoAnswerWhereTheSumCounts() {
        Convergence convergence = new Convergence(problem(false), CpuBudget.fromNow(1));

        convergence.accept(new int[][] {{0, 1, 2}, {}});
        convergence.accept(new int[][] {{0}, {1}});
        convergence.accept(new int[][] {{0, 2}, {1}});

        assertThat(convergence.points()).extracting(Convergence.Point::value).containsExactly(10.0);
        assertThat(convergence.best()).isDeepEqualTo(new int[][] {{0, 2}, {1}});
    }
}
