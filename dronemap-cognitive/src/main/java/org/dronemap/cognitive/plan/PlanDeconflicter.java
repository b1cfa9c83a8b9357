package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;

/**
 * Keeps the drones of a plan apart, one tour after the other, by later departures, waits at stops and higher legs.
 * Whoever finds no way through comes first next time.
 */
public final class PlanDeconflicter {
    private static final int MOST_ATTEMPTS = 8;

    private final PlanningProblem problem;
    private final Plan plan;
    private final LocalPlane plane;
    private final Map<DroneId, Craft> crafts;
    private final List<Tour> order;

    private PlanDeconflicter(PlanningProblem problem, Plan plan) {
        this.problem = problem;
        this.plan = plan;
        this.plane = new LocalPlane(problem.crafts().get(0).start().place().point());
        this.crafts = problem.crafts().stream().collect(Collectors.toMap(Craft::id, Function.identity()));
        this.order = new ArrayList<>(plan.tours());
        order.sort(Comparator.comparing((Tour tour) -> !craft(tour).start().airborne())
                .thenComparing(Comparator.comparingDouble(Tour::endsSeconds).reversed())
                .thenComparing(tour -> tour.drone().value()));
    }

    /** The drones of {@code plan} must be those of the problem. */
    public static DeconflictedPlan deconflict(PlanningProblem problem, Plan plan) {
        if (SeparationCheck.conflicts(problem, plan).isEmpty()) {
            return new DeconflictedPlan(plan, List.of());
        }
        Plan arranged = new PlanDeconflicter(problem, plan).arrange();
        return new DeconflictedPlan(arranged, SeparationCheck.conflicts(problem, arranged));
    }

    private Craft craft(Tour tour) {
        Craft craft = crafts.get(tour.drone());
        if (craft == null) {
            throw new IllegalArgumentException("the drone " + tour.drone() + " is not part of the problem");
        }
        return craft;
    }

    private Plan arrange() {
        Map<DroneId, Tour> placed = new HashMap<>();
        for (int attempt = 1; attempt <= MOST_ATTEMPTS; attempt++) {
            placed.clear();
            Optional<Tour> stuck = attempt(placed, attempt == MOST_ATTEMPTS);
            if (stuck.isEmpty()) {
                break;
            }
            order.remove(stuck.get());
            order.add(0, stuck.get());
        }
        return new Plan(
                plan.tours().stream()
                        .map(tour -> placed.getOrDefault(tour.drone(), tour))
                        .toList(),
                plan.unserved());
    }

    /** The tour for which there is no room; at the last attempt it stays as it is, and the others go on. */
    private Optional<Tour> attempt(Map<DroneId, Tour> placed, boolean last) {
        List<TourTrajectory> traces = new ArrayList<>();
        for (Tour tour : order) {
            Optional<Tour> found = new TourScheduler(problem, craft(tour), tour, plane, traces).find();
            if (found.isEmpty() && !last) {
                return Optional.of(tour);
            }
            Tour flown = found.orElse(tour);
            placed.put(tour.drone(), flown);
            traces.add(TourTrajectory.of(craft(tour), flown, plane));
        }
        return Optional.empty();
    }
}
