package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SolversTest {
    private final TourProblem problem = new RandomTourProblems(11).next(true, 60);

    private static void visitsEachOnce(TourProblem problem, int[][] orders) {
        assertThat(orders).hasNumberOfRows(problem.drones());
        assertThat(Arrays.stream(orders).flatMapToInt(Arrays::stream).sorted())
                .containsExactlyElementsOf(
                        IntStream.range(0, problem.waypoints().size()).boxed().toList());
    }

    @ParameterizedTest
    @ValueSource(strings = {"dronemap", "ortools", "timefold", "jsprit"})
    void searchesVisitEveryWaypointOnceAndBeatThePlainWays(String name) {
        CpuBudget allowance = CpuBudget.fromNow(4);
        Convergence convergence = new Convergence(problem, allowance);
        int[][] orders = Solvers.named(name).solve(problem, new Solver.SearchOptions(1, 1, allowance), convergence);
        int[][] plain = Solvers.named("nearest-neighbour")
                .solve(problem, new Solver.SearchOptions(1, 1, CpuBudget.fromNow(1)), better -> {});

        visitsEachOnce(problem, orders);
        assertThat(problem.value(orders)).isLessThan(problem.value(plain));
        assertThat(convergence.points()).isNotEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"given-order", "nearest-neighbour", "move-and-improve"})
    void plainWaysVisitEveryWaypointOnce(String name) {
        Solver.SearchOptions order = new Solver.SearchOptions(1, 1, CpuBudget.fromNow(1));

        visitsEachOnce(problem, Solvers.named(name).solve(problem, order, better -> {}));
    }

    @Test
    void ourSearchUsesSeveralThreadsAndNoDroneStaysIdleWhereTheSumCounts() {
        TourProblem sum = new RandomTourProblems(12).next(false, 60);
        int[][] orders =
                Solvers.named("dronemap").solve(sum, new Solver.SearchOptions(1, 2, CpuBudget.fromNow(1)), better -> {});

        visitsEachOnce(sum, orders);
        assertThat(List.of(orders)).allSatisfy(order -> assertThat(order).isNotEmpty());
    }

    @Test
    void aSolverThatNobodyKnowsIsRefused() {
        assertThatThrownBy(() -> Solvers.named("abacus"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("abacus");
    }

    @Test
    void aRunWritesHowItCameToItsTours(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("problem");
        Files.write(file, List.of("metric euclidean", "aim longest", "depot 0 0", "waypoint 1 0", "waypoint 2 0"));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();

        SolverMain.run(
                new String[] {"dronemap", file.toString(), "1", "0.2", "1", "0.1"},
                new PrintStream(bytes, true, StandardCharsets.UTF_8));

        List<String> lines = bytes.toString(StandardCharsets.UTF_8).lines().toList();
        assertThat(lines.get(0)).startsWith("about ");
        assertThat(lines).anyMatch(line -> line.matches("improved \\S+ 4\\.0"));
        assertThat(lines).anyMatch(line -> line.matches("tour (0 1|1 0)"));
    }
}
