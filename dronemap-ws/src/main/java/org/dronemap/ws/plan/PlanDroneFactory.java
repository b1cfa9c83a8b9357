package org.dronemap.ws.plan;

import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Skill;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.virtual.TourEnergyEstimate;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.DroneProblem;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;

/** Makes the planner's drone from the state of a drone; refuses one of which a fact is missing. */
public final class PlanDroneFactory {
    private static final double SECONDS_PER_MINUTE = 60;
    private static final Set<Capability> FLYING_MISSIONS =
            EnumSet.of(Capability.ARM, Capability.UPLOAD_MISSION, Capability.START_MISSION);

    private PlanDroneFactory() {}

    public static Craft of(DroneState drone) {
        ready(drone);
        VehicleKind kind = drone.identification().kind();
        Home home = drone.home();
        if (home == null) {
            throw missing(
                    new CommandProblem(OutcomeCode.HOME_UNKNOWN), drone, "Where the home of %s is, is not known.");
        }
        Place stand = stand(drone, home);
        Performance performance = Performance.of(kind, drone.identification().autopilot());
        return new Craft(
                drone.id(),
                Start.onGround(stand),
                Finish.landing(new Place(home.point(), amslMeters(drone, home.altitudeAmslMeters()))),
                performance,
                supply(drone, performance),
                skills(drone),
                home.altitudeAmslMeters(),
                1 - loss(drone));
    }

    private static void ready(DroneState drone) {
        if (drone.replay()) {
            throw missing(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    drone,
                    "%s comes from a recording; it cannot be planned with.");
        }
        if (drone.link().state() != LinkState.LIVE) {
            throw missing(DroneProblem.CONTACT_NOT_GOOD, drone, "There is no good contact with %s.");
        }
        if (drone.link().trend().isFalling()) {
            throw missing(
                    DroneProblem.LINK_FALLING,
                    drone,
                    "%s cannot be planned with. " + drone.link().trend().words());
        }
        if (drone.identification().kind() == VehicleKind.UNKNOWN
                || !drone.capabilities().known()) {
            throw missing(
                    DroneProblem.VEHICLE_UNKNOWN,
                    drone,
                    "What kind of vehicle %s is, and what it can do, is not known.");
        }
        if (!drone.capabilities().commands().containsAll(FLYING_MISSIONS)) {
            throw missing(
                    new CommandProblem(OutcomeCode.CAPABILITY_MISSING),
                    drone,
                    "%s (" + drone.identification().vehicle() + ") does not fly missions.");
        }
        if (drone.airborne()) {
            throw missing(
                    new CommandProblem(OutcomeCode.DRONE_AIRBORNE),
                    drone,
                    "%s is in the air; plans are made for drones on the ground.");
        }
    }

    /** Where it is now, on the ground. */
    static Place stand(DroneState drone, Home home) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        Double amsl = position == null ? null : position.altitudeAmslMeters();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        if (point == null) {
            throw missing(DroneProblem.POSITION_UNKNOWN, drone, "Where %s is, is not known.");
        }
        if (above != null) {
            return new Place(point, amslMeters(drone, home.altitudeAmslMeters() + above));
        }
        if (amsl == null) {
            throw missing(DroneProblem.POSITION_UNKNOWN, drone, "How high %s stands is not known.");
        }
        return new Place(point, amslMeters(drone, amsl));
    }

    private static double amslMeters(DroneState drone, double meters) {
        if (!(meters >= Altitude.LOWEST_PLANNED_METERS && meters <= Altitude.HIGHEST_PLANNED_METERS)) {
            throw Rejection.of(
                    DroneProblem.ALTITUDE_IMPLAUSIBLE,
                    "The altitude that “" + drone.name() + "” tells (" + Math.round(meters) + " m) cannot be.",
                    ProblemParameter.DRONE.is(drone.id().value()),
                    ProblemParameter.ALTITUDE.is(meters));
        }
        return meters;
    }

    private static EnergyBudget supply(DroneState drone, Performance performance) {
        Battery battery = drone.battery();
        Integer percent = battery == null ? null : battery.percent();
        if (percent == null) {
            throw missing(DroneProblem.BATTERY_UNKNOWN, drone, "How full the battery of %s is, is not known.");
        }
        return new EnergyBudget(
                joules(percent, drone, performance), joules(DroneSelection.RESERVE_PERCENT, drone, performance));
    }

    /** The size of batteries is not told by vehicles: so long as one of its kind flies with that charge. */
    private static double joules(double percent, DroneState drone, Performance performance) {
        return TourEnergyEstimate.minutesOf(percent, drone.identification().kind())
                * SECONDS_PER_MINUTE
                * performance.power().cruise();
    }

    static Set<Skill> skills(DroneState drone) {
        return drone.capabilities().commands().stream().map(Skill::of).collect(Collectors.toUnmodifiableSet());
    }

    private static double loss(DroneState drone) {
        LinkQuality quality = drone.link().quality();
        Double loss = quality.lossShort() == null ? quality.lossLong() : quality.lossShort();
        if (loss == null) {
            throw missing(
                    DroneProblem.LINK_QUALITY_UNKNOWN,
                    drone,
                    "How good the link of %s is, is not known yet; that takes some seconds of contact.");
        }
        return Math.max(0, Math.min(1, loss));
    }

    private static Rejection missing(ProblemCode code, DroneState drone, String sentence) {
        return Rejection.of(
                code,
                sentence.replace("%s", "“" + drone.name() + "”"),
                ProblemParameter.DRONE.is(drone.id().value()));
    }
}
