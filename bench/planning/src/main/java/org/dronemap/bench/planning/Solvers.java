package org.dronemap.bench.planning;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.dronemap.bench.planning.library.JspritSolver;
import org.dronemap.bench.planning.library.OrToolsSolver;
import org.dronemap.bench.planning.library.TimefoldSolver;
import org.dronemap.cognitive.allocate.GivenOrderBaseline;
import org.dronemap.cognitive.allocate.MoveAndImproveBaseline;
import org.dronemap.cognitive.allocate.NearestNeighbourBaseline;

/** A registry of the solvers by name; loads only the one that is asked for. */
final class Solvers {
    private static final Map<String, Supplier<Solver>> KNOWN = new TreeMap<>(Map.of(
            "dronemap", DronemapSolver::new,
            "ortools", OrToolsSolver::new,
            "timefold", TimefoldSolver::new,
            "jsprit", JspritSolver::new,
            "given-order", () -> new BaselineSolver("waypoints as they come, cut into equal stretches", new GivenOrderBaseline()),
            "nearest-neighbour", () -> new BaselineSolver("the shortest tour goes on to the nearest", new NearestNeighbourBaseline()),
            "move-and-improve", () -> new BaselineSolver("market of drones after Koubaa et al.", new MoveAndImproveBaseline())));

    private Solvers() {}

    static Solver named(String name) {
        Supplier<Solver> found = KNOWN.get(name);
        if (found == null) {
            throw new IllegalArgumentException("there is no solver '" + name + "', only " + KNOWN.keySet());
        }
        return found.get();
    }
}
