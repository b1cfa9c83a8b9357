package org.dronemap.ws.operation;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.DroneSelection;
import org.dronemap.core.virtual.ServiceDemand;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualTour;
import org.dronemap.core.virtual.VirtualTourSection;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/**
 * Chooses the drone of an operation that is to come to a place, by the same criteria as for virtual drones. Any thread.
 */
public final class PoolDroneSelector {
    private static final double SECONDS = 60;

    private final CloudManager cloud;

    public PoolDroneSelector(CloudManager cloud) {
        this.cloud = cloud;
    }

    /**
     * Task of a drone: come, stay for so many minutes, return home.
     *
     * @param heightMeters above the drone's home
     * @param capabilities beside what every mission takes
     */
    public record Task(Geodetic near, double heightMeters, double minutes, Set<Capability> capabilities) {
        public Task {
            capabilities = Set.copyOf(capabilities);
        }

        private ServiceDemand demand(@Nullable Wind wind) {
            Altitude height = new Altitude(heightMeters, Altitude.Reference.HOME);
            // In whole seconds, as vehicles count the time at a waypoint.
            MissionItem.Waypoint there = new MissionItem.Waypoint(near, height, Math.ceil(minutes * SECONDS));
            DroneRequirements needs = new DroneRequirements(null, capabilities, null, null);
            return new ServiceDemand(needs, new VirtualTour(heightMeters, List.of(there), false), 0, wind);
        }
    }

    /** {@code chosen}: empty, and {@code why} each cannot. */
    public record Found(Optional<ChosenDrone> chosen, String why) {}

    /** Among these. */
    public Found find(Principal principal, List<DroneState> drones, Task task, Instant now) {
        Wind wind = Wind.near(task.near(), seen(principal), now).orElse(null);
        DroneSelection selection =
                DroneSelection.of(task.demand(wind), drones, (drone, share) -> objection(principal, drone, share));
        Function<DroneId, String> names = id -> drones.stream()
                .filter(drone -> drone.id().equals(id))
                .map(DroneState::name)
                .findFirst()
                .orElse(id.value());
        return new Found(
                selection.choice().map(choice -> chosen(choice.chosen(), choice.sentence(names))),
                selection.unfit().stream()
                        .map(one -> names.apply(one.drone()) + ": " + one.why().sentence())
                        .collect(Collectors.joining(" ")));
    }

    private ChosenDrone chosen(DroneId id, String why) {
        DroneState drone = cloud.drone(id).orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, id.value()));
        Home home = drone.home();
        if (home == null) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.HOME_UNKNOWN),
                    "Where the home of " + drone.name() + " is, is not known any more.",
                    ProblemParameter.DRONE.is(id.value()));
        }
        return new ChosenDrone(id, drone.name(), home.point(), home.altitudeAmslMeters(), why);
    }

    private Optional<UnfitReason> objection(Principal principal, DroneState drone, VirtualTourSection share) {
        ControlState control = cloud.controls().control(drone.id());
        if (control.tenure() != null && !control.isHeldBy(principal.name())) {
            return Optional.of(UnfitReason.of(new Refusal(OutcomeCode.CONTROL_HELD, control.sentence())));
        }
        // Whether zones let it go there and back.
        return cloud.gate()
                .whyNot(principal, drone, new Command.UploadMission(share.mission()))
                .map(UnfitReason::of);
    }

    /** It stands in the air and waits for what it is told, and nobody has control of it. */
    public boolean isLeftAloft(DroneId id) {
        return cloud.controls().control(id).tenure() == null
                && cloud.drone(id)
                        .filter(DroneState::airborne)
                        .filter(drone -> drone.capabilities()
                                .steering(drone.mode())
                                .filter(Steering::acceptsCommands)
                                .isPresent())
                        .isPresent();
    }

    /** In the hands of no one, nor of their user. */
    public boolean isFree(DroneId id) {
        return cloud.controls().control(id).tenure() == null;
    }

    /** That the user may command. */
    public List<DroneState> commandable(Principal principal) {
        return seen(principal).stream()
                .filter(drone -> principal.may(Role.OPERATOR, drone.id()))
                .toList();
    }

    private List<DroneState> seen(Principal principal) {
        return cloud.drones().stream()
                .filter(drone -> principal.sees(drone.id()))
                .toList();
    }
}
