package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.jspecify.annotations.Nullable;

/** Writes down every way to share waypoints out and to order them, and judges each. */
final class BruteForcePlans {
    private final AllocationOracle judge;
    private final int waypoints;
    private final List<List<Integer>> orders = new ArrayList<>();
    private AllocationOracle.@Nullable Expectation best;

    private BruteForcePlans(AllocationProblem instance) {
        judge = new AllocationOracle(instance);
        waypoints = instance.visits().size();
        for (int r = 0; r < instance.carriers().size(); r++) {
            orders.add(new ArrayList<>());
        }
    }

    static AllocationOracle.Expectation best(AllocationProblem instance) {
        BruteForcePlans all = new BruteForcePlans(instance);
        all.place(0);
        if (all.best == null) {
            throw new IllegalStateException("not even the empty plan");
        }
        return all.best;
    }

    private void place(int waypoint) {
        if (waypoint == waypoints) {
            int[][] plan = orders.stream()
                    .map(order -> order.stream().mapToInt(Integer::intValue).toArray())
                    .toArray(int[][]::new);
            if (judge.faults(plan).isEmpty()) {
                AllocationOracle.Expectation verdict = judge.verdict(plan);
                best = best == null || best.isWorseThan(verdict) ? verdict : best;
            }
            return;
        }
        place(waypoint + 1);
        for (List<Integer> order : orders) {
            for (int at = 0; at <= order.size(); at++) {
                order.add(at, waypoint);
                place(waypoint + 1);
                order.remove(at);
            }
        }
    }
}
