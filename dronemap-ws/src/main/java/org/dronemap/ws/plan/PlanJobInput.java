package org.dronemap.ws.plan;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.WaysHome;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
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

    /** Refuses to start more drones at once than have a way home apart from each other. */
    void requireWaysHome(Plan plan) {
        WaysHome.of(
                        problem,
                        plan,
                        drone -> drones.stream()
                                .filter(state -> state.id().equals(drone))
                                .map(DroneState::identification)
                                .anyMatch(identity -> identity.kind().isRotorcraft()))
                .shortage()
                .ifPresent(shortage -> {
                    throw Rejection.of(
                            OperationProblem.WAYS_HOME_DO_NOT_FIT,
                            sentence(shortage),
                            ProblemParameter.DRONES.is(shortage.drones()),
                            ProblemParameter.MOST.is(shortage.fitting()));
                });
    }

    private String sentence(WaysHome.Shortage shortage) {
        boolean level = shortage.unevenMeters() == shortage.apartMeters();
        return String.format(
                Locale.ROOT,
                "%d of %d drones have a way home between %.0f m (%s) and the ceiling of %.0f m above the home of “%s”:"
                        + " layers are %.0f m apart%s. Take off fewer at once, raise the ceiling, or keep their areas and"
                        + " pads %.0f m apart.",
                shortage.fitting(),
                shortage.drones(),
                shortage.flownMeters(),
                shortage.isFlown() ? "the highest way" : "as high as they return at least",
                shortage.ceilingMeters(),
                nameOf(shortage.without()),
                shortage.apartMeters(),
                level
                        ? ""
                        : String.format(
                                Locale.ROOT, ", %.0f m where homes are not known to be level", shortage.unevenMeters()),
                shortage.besideMeters());
    }
}
