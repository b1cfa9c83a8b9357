package org.dronemap.ws.plan;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.jspecify.annotations.Nullable;

/**
 * Input of a planning job: the problem, the drones as they were when it was requested, search time and seed.
 *
 * @param drones those of the problem, as they were when it was asked for
 * @param search for how long
 * @param ofPool the request that it came from, where the cloud chose the drones of the pool; null: they were named
 */
public record PlanJobInput(
        PlanningProblem problem,
        List<DroneState> drones,
        Duration search,
        long seed,
        @Nullable PlanRequest ofPool) {
    /** For drones that were named. */
    public PlanJobInput(PlanningProblem problem, List<DroneState> drones, Duration search, long seed) {
        this(problem, drones, search, seed, null);
    }

    /** So many drones of the pool fly it at most; null: they were named. */
    public @Nullable Integer upTo() {
        return ofPool == null ? null : ofPool.upTo();
    }

    public PlanJobInput {
        drones = List.copyOf(drones);
    }

    private Optional<DroneState> drone(DroneId id) {
        return drones.stream().filter(drone -> drone.id().equals(id)).findFirst();
    }

    String nameOf(DroneId id) {
        return drone(id).map(DroneState::name).orElse(id.value());
    }

    /** Who writes missions for that drone; empty when it is none of these. */
    Optional<PlanMissionWriter> missions(DroneId id) {
        Optional<Craft> craft =
                problem.crafts().stream().filter(one -> one.id().equals(id)).findFirst();
        return craft.flatMap(one -> drone(id)
                .map(drone -> new PlanMissionWriter(one, drone.identification().kind(), this::task)));
    }

    private Task task(String waypoint) {
        return problem.waypoints().stream()
                .filter(one -> one.id().equals(waypoint))
                .findFirst()
                .map(Waypoint::task)
                .orElse(Task.FLY_THROUGH);
    }

    /** Why that plan must not be flown: what its checker says, and what no mission can hold. */
    List<String> faults(PlanResult planned) {
        List<String> faults = new ArrayList<>(planned.faults());
        for (Tour tour : planned.plan().tours()) {
            missions(tour.drone()).flatMap(missions -> missions.fault(tour)).ifPresent(faults::add);
        }
        return faults;
    }
}
