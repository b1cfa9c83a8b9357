package org.dronemap.ws.plan;

import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.PlanningRules;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Builds the planning problem of one drone whose waypoints are to be ordered, from a client's request. Less has to be
 * known of the drone than for a plan that is flown: an order is a proposal to who edits a mission, whatever the battery
 * holds now. Any thread.
 */
final class TourReader {
    private static final String COUNT = "1 to " + Mission.MAX_ITEMS + " waypoints";
    private static final String ENDINGS = "returnToLaunch, hold or land";
    private static final double USUAL_SECONDS = 1;
    static final double LEAST_SECONDS = 0.1;
    static final int MOST_SECONDS = 5;
    private static final double MILLIS = 1_000;

    private final DroneService drones;
    private final ZoneRegistry zones;
    private final Clock clock;

    TourReader(DroneService drones, ZoneRegistry zones, Clock clock) {
        this.drones = drones;
        this.zones = zones;
        this.clock = clock;
    }

    /**
     * Planning problem of one drone whose waypoints are to be ordered, with the search time.
     *
     * @param lastStays whether the last waypoint is where the drone ends, and none of the problem's
     */
    record Tour(PlanningProblem problem, boolean lastStays, Duration search) {}

    Tour read(Principal principal, TourRequest request) {
        Duration search = search(request.seconds());
        boolean lastStays = lastStays(request.ending());
        String id = request.drone();
        if (id == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        Craft craft = craft(drones.state(principal, id, Role.PLANNER));
        if (request.waypoints() != null && request.waypoints().size() > Mission.MAX_ITEMS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "waypoints",
                    COUNT,
                    request.waypoints().size(),
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(Mission.MAX_ITEMS));
        }
        List<Waypoint> all = new PlanWaypointReader(List.of(craft)).read(request.waypoints());
        Waypoint last = all.get(all.size() - 1);
        List<Waypoint> free = lastStays ? all.subList(0, all.size() - 1) : all;
        List<Craft> crafts = List.of(lastStays ? craft.with(Finish.hovering(last.place())) : craft);
        try {
            PlanningProblem problem = new PlanningProblem(
                    free,
                    crafts,
                    PlanBarriers.of(principal.name(), zones, all, crafts, clock.instant()),
                    UniformWind.CALM,
                    Objective.earliestEnd(),
                    PlanningRules.USUAL);
            return new Tour(problem, lastStays, search);
        } catch (IllegalArgumentException tooMuch) {
            throw InvalidInput.unplannable(tooMuch);
        }
    }

    private static Craft craft(DroneState drone) {
        Home home = drone.home();
        if (home == null) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.HOME_UNKNOWN),
                    "Where the home of “" + drone.name() + "” is, is not known.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        Place base = new Place(home.point(), home.altitudeAmslMeters());
        Place stand = drone.position() == null || drone.position().point() == null
                ? base
                : PlanDroneFactory.stand(drone, home);
        return new Craft(
                drone.id(),
                drone.airborne() ? Start.inFlight(stand) : Start.onGround(stand),
                Finish.landing(base),
                Performance.of(
                        drone.identification().kind(), drone.identification().autopilot()),
                EnergyBudget.UNLIMITED,
                Set.copyOf(PlanDroneFactory.skills(drone)),
                home.altitudeAmslMeters(),
                1);
    }

    private static boolean lastStays(@Nullable String ending) {
        return switch (ending == null ? "returnToLaunch" : ending) {
            case "returnToLaunch" -> false;
            case "hold", "land" -> true;
            default ->
                throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "ending", ENDINGS, "\"" + ending + "\"");
        };
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
}
