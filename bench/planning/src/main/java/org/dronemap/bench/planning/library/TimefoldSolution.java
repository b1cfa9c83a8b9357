package org.dronemap.bench.planning.library;

import ai.timefold.solver.core.api.domain.solution.PlanningEntityCollectionProperty;
import ai.timefold.solver.core.api.domain.solution.PlanningScore;
import ai.timefold.solver.core.api.domain.solution.PlanningSolution;
import ai.timefold.solver.core.api.domain.solution.ProblemFactCollectionProperty;
import ai.timefold.solver.core.api.domain.solution.ProblemFactProperty;
import ai.timefold.solver.core.api.domain.valuerange.ValueRangeProvider;
import ai.timefold.solver.core.api.score.buildin.simplelong.SimpleLongScore;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.bench.planning.TourProblem;
import org.jspecify.annotations.Nullable;

/** A problem and its tours as Timefold sees them. */
@PlanningSolution
public class TimefoldSolution {
    @ProblemFactProperty
    private Distances distances = new Distances(new double[0][]);

    @ProblemFactCollectionProperty
    @ValueRangeProvider
    private List<TimefoldStop> stops = List.of();

    @PlanningEntityCollectionProperty
    private List<TimefoldRoute> routes = List.of();

    @PlanningScore
    private @Nullable SimpleLongScore score;

    /** Between all places of the problem. */
    static final class Distances {
        private final double[][] between;

        Distances(double[][] between) {
            this.between = between;
        }
    }

    TimefoldSolution() {}

    static TimefoldSolution of(TourProblem problem) {
        TimefoldSolution plan = new TimefoldSolution();
        plan.distances = new Distances(problem.distances());
        plan.stops = IntStream.range(0, problem.waypoints().size())
                .mapToObj(TimefoldStop::new)
                .toList();
        plan.routes = IntStream.range(0, problem.drones()).mapToObj(TimefoldRoute::new).toList();
        return plan;
    }

    double[][] distances() {
        return distances.between;
    }

    int waypoints() {
        return stops.size();
    }

    List<TimefoldRoute> routes() {
        return routes;
    }

    /** Whether all waypoints are in some tour. */
    boolean isWhole() {
        return routes.stream().mapToInt(route -> route.stops().size()).sum() == stops.size();
    }

    int[][] orders() {
        return routes.stream()
                .map(route -> route.stops().stream().mapToInt(TimefoldStop::waypoint).toArray())
                .toArray(int[][]::new);
    }

    @Nullable
    SimpleLongScore score() {
        return score;
    }
}
