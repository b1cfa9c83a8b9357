package org.dronemap.ws.plan;

import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.PlanningRules;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/**
 * Builds the planning problem of several drones from a client's request, the drones' states and the zones. Any thread.
 */
final class PlanReader {
    static final String DRONES_FORM = "a list of 1 to 100 ids of drones";
    static final int MOST_DRONES = 100;
    private static final double USUAL_SECONDS = 5;
    static final double LEAST_SECONDS = 0.1;
    static final int MOST_SECONDS = 60;
    /** In m/s. */
    static final int STRONGEST_WIND = 100;
    /** In degrees. */
    static final int FULL_CIRCLE = 360;

    private static final double MILLIS = 1_000;
    private static final double LEAST_LINK_QUALITY = 1 - DroneSelection.WORST_LOSS_PERCENT / 100.0;

    private final DroneService drones;
    private final PoolPlanDrones pool;
    private final ZoneRegistry zones;
    private final PlanningRules rules;
    private final Clock clock;

    /** {@code apart}: what plans keep between any two drones, at least. */
    PlanReader(DroneService drones, PoolPlanDrones pool, ZoneRegistry zones, Separation apart, Clock clock) {
        this.drones = drones;
        this.pool = pool;
        this.zones = zones;
        this.rules = new PlanningRules(apart.aimedFor(), LEAST_LINK_QUALITY, 3, 5);
        this.clock = clock;
    }

    PlanJobInput read(Principal principal, PlanRequest request) {
        Duration search = search(request.seconds());
        PlanObjectiveRequest asked = request.objective();
        Objective objective = asked == null ? Objective.earliestEnd() : asked.read("objective.");
        UniformWind wind = wind(request.wind());
        List<DroneState> states = states(principal, request);
        List<Craft> crafts = states.stream().map(PlanDroneFactory::of).toList();
        List<Waypoint> waypoints = new PlanWaypointReader(crafts).read(request.waypoints());
        List<Barrier> barriers = PlanBarriers.of(principal.name(), zones, waypoints, crafts, clock.instant());
        try {
            PlanningProblem problem = new PlanningProblem(waypoints, crafts, barriers, wind, objective, rules);
            Long seed = request.seed();
            return new PlanJobInput(
                    problem, states, search, seed == null ? 1 : seed, request.upTo() == null ? null : request);
        } catch (IllegalArgumentException tooMuch) {
            throw InvalidInput.unplannable(tooMuch);
        }
    }

    private List<DroneState> states(Principal principal, PlanRequest request) {
        Integer upTo = request.upTo();
        if (upTo == null) {
            return named(principal, request.drones());
        }
        if (request.drones() != null) {
            throw new InvalidInput(
                    ValueProblem.VALUE_NOT_ALLOWED,
                    "upTo",
                    "either drones or upTo",
                    "A plan is either for drones that are named (drones) or for some of the pool (upTo), not for both.");
        }
        int most = (int) FieldRanges.checked("upTo", (double) upTo, 1, MOST_DRONES, "drones");
        PoolPlanDrones.Found found = pool.find(principal, most, places(request), Set.of());
        if (found.chosen().isEmpty()) {
            throw Rejection.of(
                    OperationProblem.NO_DRONE_TO_PLAN, "No drone of the pool can be planned with now. " + found.why());
        }
        return found.chosen();
    }

    /** As far as they can be read: what is wrong with them is said by who reads them all. */
    private static List<Geodetic> places(PlanRequest request) {
        List<Geodetic> places = new ArrayList<>();
        for (PlanRequest.WaypointRequest one :
                Objects.requireNonNullElse(request.waypoints(), List.<PlanRequest.@Nullable WaypointRequest>of())) {
            if (one != null
                    && one.latitude() != null
                    && one.longitude() != null
                    && Math.abs(one.latitude()) <= FieldRanges.LATITUDE
                    && Math.abs(one.longitude()) <= FieldRanges.LONGITUDE) {
                places.add(new Geodetic(one.latitude(), one.longitude()));
            }
        }
        return places;
    }

    private List<DroneState> named(Principal principal, @Nullable List<@Nullable String> asked) {
        if (asked == null || asked.isEmpty()) {
            throw InvalidInput.missing("drones", DRONES_FORM + ", or upTo instead");
        }
        Set<String> each = new LinkedHashSet<>();
        for (String drone : asked) {
            if (drone == null) {
                throw InvalidInput.outside(
                        ValueProblem.VALUE_MALFORMED, "drones", DRONES_FORM, "a list with null in it");
            }
            each.add(drone);
        }
        if (each.size() > MOST_DRONES) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "drones",
                    DRONES_FORM,
                    each.size() + " ids",
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_DRONES));
        }
        List<DroneState> states = new ArrayList<>();
        each.forEach(drone -> states.add(drones.state(principal, drone, Role.PLANNER)));
        return states;
    }

    private static Duration search(@Nullable Double seconds) {
        double asked = seconds == null ? USUAL_SECONDS : seconds;
        if (!(asked >= LEAST_SECONDS && asked <= MOST_SECONDS)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "seconds",
                    LEAST_SECONDS + " to " + MOST_SECONDS + " seconds",
                    asked,
                    ProblemParameter.LEAST.is(LEAST_SECONDS),
                    ProblemParameter.MOST.is(MOST_SECONDS),
                    ProblemParameter.UNIT.is("seconds"));
        }
        return Duration.ofMillis(Math.round(asked * MILLIS));
    }

    private static UniformWind wind(PlanRequest.@Nullable WindRequest asked) {
        return asked == null
                ? UniformWind.CALM
                : new UniformWind(
                        FieldRanges.checked("wind.speed", asked.speed(), 0, STRONGEST_WIND, "m/s"),
                        FieldRanges.checked("wind.from", asked.from(), 0, FULL_CIRCLE, "degrees"));
    }
}
