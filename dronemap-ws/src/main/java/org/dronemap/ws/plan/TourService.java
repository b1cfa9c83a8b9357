package org.dronemap.ws.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.stream.IntStream;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;

/**
 * Proposes a good order for the waypoints of one drone's mission, for an editor; it sends nothing to the drone. Any
 * thread.
 */
final class TourService implements AutoCloseable {
    private static final int QUEUED = 8;
    private static final long SEED = 1;

    private final TourReader reader;
    private final Time time;
    private final Pool pool;
    private final Set<String> waiting = ConcurrentHashMap.newKeySet();

    TourService(DroneService drones, ZoneRegistry zones, Time time) {
        this.time = time;
        pool = time.pool("tours", 1, QUEUED);
        reader = new TourReader(drones, zones, time.clock());
    }

    /** One at a time for each user; refused while too many wait. */
    CompletableFuture<TourView> order(Principal principal, TourRequest request) {
        RoleChecks.require(principal, Role.PLANNER);
        TourReader.Tour tour = reader.read(principal, request);
        if (!waiting.add(principal.name())) {
            throw Rejection.of(
                    OperationProblem.TOUR_UNDER_WAY, "A tour of yours is being ordered already; wait for it.");
        }
        try {
            return CompletableFuture.supplyAsync(() -> ordered(tour), pool)
                    .whenComplete((done, failed) -> waiting.remove(principal.name()));
        } catch (RejectedExecutionException full) {
            waiting.remove(principal.name());
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY,
                    QUEUED + " tours wait to be ordered already; try again in a minute.",
                    ProblemParameter.WHAT.is("tours"));
        }
    }

    private TourView ordered(TourReader.Tour tour) {
        PlanningProblem problem = tour.problem();
        Plan listed = FleetPlanner.asListed(problem);
        PlanResult found =
                FleetPlanner.plan(problem, SEED, SearchBudget.time(tour.search(), time.effort()), better -> {});
        Map<String, Integer> numbers = new LinkedHashMap<>();
        IntStream.range(0, problem.waypoints().size())
                .forEach(number -> numbers.put(problem.waypoints().get(number).id(), number));
        List<Integer> order = new ArrayList<>();
        found.plan().tours().stream()
                .flatMap(one -> one.stops().stream())
                .map(TourStop::waypoint)
                .forEach(waypoint -> order.add(numbers.remove(waypoint)));
        order.addAll(numbers.values());
        if (tour.lastStays()) {
            order.add(order.size());
        }
        return new TourView(
                order,
                effort(listed),
                effort(found.plan()),
                found.plan().unserved().isEmpty() ? found.progress().gap() : 1,
                PlanViewMapper.unserved(problem, found.plan()));
    }

    private static TourView.EffortView effort(Plan plan) {
        return new TourView.EffortView(
                plan.endsSeconds(),
                plan.tours().stream()
                        .flatMap(tour -> tour.ways().stream())
                        .mapToDouble(PlanViewMapper::meters)
                        .sum());
    }

    @Override
    public void close() {
        pool.close();
    }
}
