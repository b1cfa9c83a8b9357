package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ConvergenceTest {
    @Test
    void onlyBetterToursAreNoted() {
        TourProblem problem = new TourProblem(
                Metric.EUCLIDEAN,
                true,
                List.of(new Spot(0, 0), new Spot(0, 0)),
                List.of(new Spot(1, 0), new Spot(2, 0), new Spot(-2, 0)));
        Convergence convergence = new Convergence(problem, Allowance.fromNow(1));

        convergence.accept(new int[][] {{0, 1, 2}, {}});
        convergence.accept(new int[][] {{2, 0, 1}, {}});
        convergence.accept(new int[][] {{0, 1}, {2}});

        assertThat(convergence.points()).extracting(Convergence.Point::value).containsExactly(8.0, 4.0);
    }
}
