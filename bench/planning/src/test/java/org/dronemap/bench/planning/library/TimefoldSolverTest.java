package org.dronemap.bench.planning.library;

import static org.assertj.core.api.Assertions.assertThat;

import ai.timefold.solver.core.config.solver.EnvironmentMode;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.bench.planning.CpuBudget;
import org.dronemap.bench.planning.Metric;
import org.dronemap.bench.planning.Solver;
import org.dronemap.bench.planning.TourPoint;
import org.dronemap.bench.planning.TourProblem;
import org.junit.jupiter.api.Test;

class TimefoldSolverTest {
    @Test
    void itsIncrementalScoreIsThatOfTheWholePlanAfterEveryMove() {
        List<TourPoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            waypoints.add(new TourPoint(i * 37 % 101, i * 53 % 97));
        }
        TourProblem problem = new TourProblem(
                Metric.EUCLIDEAN, true, List.of(new TourPoint(0, 0), new TourPoint(0, 0), new TourPoint(50, 50)), waypoints);

        // In this mode the library itself compares both scores, and throws when they differ.
        int[][] orders = new TimefoldSolver(EnvironmentMode.FULL_ASSERT)
                .solve(problem, new Solver.SearchOptions(1, 1, CpuBudget.fromNow(6)), better -> {});

        assertThat(problem.value(orders)).isLessThan(500);
    }
}
