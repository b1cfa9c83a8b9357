package org.dronemap.cognitive.replan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** The waypoints that drones are flying, as indexes into a re-planning's problem. Never changes. */
final class IndexedAssignments {
    private final PlanningProblem problem;
    private final int[][] firm;
    private final int[][] orders;
    private final @Nullable DroneId[] owners;
    private final BitSet busy;

    private IndexedAssignments(
            PlanningProblem problem, int[][] firm, int[][] orders, @Nullable DroneId[] owners, BitSet busy) {
        this.problem = problem;
        this.firm = firm;
        this.orders = orders;
        this.owners = owners;
        this.busy = busy;
    }

    static IndexedAssignments of(ReplanSituation situation) {
        PlanningProblem problem = situation.problem();
        Map<String, Integer> numbers = new HashMap<>();
        for (int i = 0; i < problem.waypoints().size(); i++) {
            numbers.put(problem.waypoints().get(i).id(), i);
        }
        Map<DroneId, LiveAssignment> live = new HashMap<>();
        @Nullable DroneId[] owners = new DroneId[problem.waypoints().size()];
        for (LiveAssignment order : situation.live()) {
            live.put(order.drone(), order);
            order.waypoints()
                    .map(numbers::get)
                    .filter(Objects::nonNull)
                    .forEach(waypoint -> owners[waypoint] = order.drone());
        }
        int drones = problem.crafts().size();
        int[][] firm = new int[drones][];
        int[][] orders = new int[drones][];
        BitSet busy = new BitSet();
        for (int r = 0; r < drones; r++) {
            DroneId id = problem.crafts().get(r).id();
            LiveAssignment order = live.getOrDefault(id, LiveAssignment.of(id, List.of()));
            firm[r] = known(numbers, order.firm());
            orders[r] = known(numbers, order.waypoints().toList());
            busy.set(r, order.busy());
        }
        return new IndexedAssignments(problem, firm, orders, owners, busy);
    }

    private static int[] known(Map<String, Integer> numbers, List<String> waypoints) {
        return waypoints.stream()
                .map(numbers::get)
                .filter(Objects::nonNull)
                .mapToInt(Integer::intValue)
                .toArray();
    }

    int[][] firm() {
        return firm;
    }

    /** With what is firm. */
    int[][] orders() {
        return orders;
    }

    /** Drones that could not be told of anything more for a while. */
    BitSet busy() {
        return busy;
    }

    /** What new orders make of these. */
    ReplanResult.Changes changes(int[][] renewed) {
        @Nullable DroneId[] now = new DroneId[owners.length];
        List<DroneId> drones = new ArrayList<>();
        for (int r = 0; r < renewed.length; r++) {
            DroneId drone = problem.crafts().get(r).id();
            for (int waypoint : renewed[r]) {
                now[waypoint] = drone;
            }
            if (!Arrays.equals(renewed[r], orders[r])) {
                drones.add(drone);
            }
        }
        List<ReassignedWaypoint> moved = new ArrayList<>();
        for (int waypoint = 0; waypoint < now.length; waypoint++) {
            if (!Objects.equals(now[waypoint], owners[waypoint])) {
                moved.add(new ReassignedWaypoint(
                        problem.waypoints().get(waypoint).id(), owners[waypoint], now[waypoint]));
            }
        }
        return new ReplanResult.Changes(moved, drones);
    }
}
