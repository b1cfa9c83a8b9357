package org.dronemap.bench.planning.library;

import static org.assertj.core.api.Assertions.assertThat;

import ai.timefold.solver.core.config.solver.EnvironmentMode;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.bench.planning.Allowance;
import org.dronemap.bench.planning.Metric;
import org.dronemap.bench.planning.Solver;
import org.dronemap.bench.planning.Spot;
import org.dronemap.bench.planning.TourProblem;
import org.junit.jupiter.api.Test;

class TimefoldSolverTest {
    @Test
    void itsIncrementalScoreIsThatOfTheWholePlanAfterEveryMove() {
        List<Spot> waypoints = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            waypoints.add(new Spot(i * 37 % 101, i * 53 % 97));
        }
        TourProblem problem = new TourProblem(
                Metric.EUCLIDEAN, true, List.of(new Spot(0, 0), new Spot(0, 0), new Spot(50, 50)), waypoints);

        // In this mode the library itself compares both scores, and throws when they differ.
        int[][] orders = new TimefoldSolver(EnvironmentMode.FULL_ASSERT)
                .solve(problem, new Solver.Order(1, 1, Allowance.fromNow(6)), better -> {});

        assertThat(problem.value(orders)).isLessThan(500);
    }
}
