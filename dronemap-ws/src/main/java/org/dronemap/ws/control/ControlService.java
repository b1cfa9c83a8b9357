package org.dronemap.ws.control;

import java.util.concurrent.CompletionException;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.UnknownDroneException;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseDenial;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.drone.ControlView;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.ControlProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemCode;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Lets users see, take, request, grant, hand over and release the control of a drone. Any thread. */
public final class ControlService {
    private static final Logger LOG = LoggerFactory.getLogger(ControlService.class);

    private final CloudManager cloud;
    private final DroneService drones;
    private final AccessStore access;
    private final GrantRegistry grants;
    private final OutletGateway outlet;

    /** Control of a drone after a request; {@code waiting}: the present holder was asked, and decides. */
    public record Answer(ControlView control, boolean waiting) {}

    public ControlService(
            CloudManager cloud,
            DroneService drones,
            AccessStore access,
            AccountChanges accounts,
            GrantRegistry grants,
            OutletGateway outlet) {
        this.cloud = cloud;
        this.drones = drones;
        this.access = access;
        this.grants = grants;
        this.outlet = outlet;
        accounts.onChange(user -> judgeAnew());
        grants.onChange(this::judgeAnew);
    }

    public ControlView control(Principal principal, String droneId) {
        return ControlView.of(cloud.controls()
                .control(drones.state(principal, droneId, Role.VIEWER).id()));
    }

    /** Does what is asked, or says who has control and since when. */
    public Answer act(Principal principal, String droneId, ControlRequest request) {
        DroneState drone = drone(principal, droneId, request.action());
        if (drone.replay()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    "This is a recording; it cannot be commanded.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        LeaseStep step = apply(drone.id(), request.read(principal.name(), user -> pilot(user, drone.id())));
        if (step.answer() instanceof LeaseAnswer.Denied denied) {
            throw Rejection.ofControl(code(denied.reason()), denied.why(), drone.id(), step.control());
        }
        return new Answer(ControlView.of(step.control()), step.answer() instanceof LeaseAnswer.Waiting);
    }

    /** Planners come to control by putting a mission on a drone, and must be able to give it back. */
    private DroneState drone(Principal principal, String id, ControlAction action) {
        return switch (action) {
            case TAKE_OVER -> drones.state(principal, id, Role.SUPERVISOR);
            // Whoever may command may give back, too, and need not be allowed to plan for that.
            case RELEASE -> drones.state(principal, id, Role.OPERATOR, Role.PLANNER);
            default -> drones.state(principal, id, Role.OPERATOR);
        };
    }

    private static ProblemCode code(LeaseDenial reason) {
        return switch (reason) {
            case HELD -> new CommandProblem(OutcomeCode.CONTROL_HELD);
            case ENDED -> new CommandProblem(OutcomeCode.CONTROL_ENDED);
            case NOT_HELD -> ControlProblem.NOT_HELD;
            case OWN -> ControlProblem.OWN;
            case REQUESTS_FULL -> ControlProblem.REQUESTS_FULL;
            case NOT_ASKED -> ControlProblem.NOT_ASKED;
            case NOT_TAKEN -> ControlProblem.NOT_TAKEN;
        };
    }

    private LeaseStep apply(DroneId drone, LeaseEvent event) {
        try {
            return cloud.controls().apply(drone, event);
        } catch (UnknownDroneException removedMeanwhile) {
            throw Rejection.unknown(NotFoundProblem.DRONE, drone.value());
        } catch (CompletionException notWritten) {
            LOG.warn("A change of who has control of {} could not be written down", drone, notWritten);
            throw Rejection.of(
                    ServerProblem.CHANGE_NOT_KEPT,
                    "Control has changed as you asked, but that could not be written down: should the server be started"
                            + " anew now, it may be as it was before.");
        }
    }

    /** Control goes to nobody who may not command. */
    private String pilot(@Nullable String user, DroneId drone) {
        String name = ControlRequest.named(user);
        if (!mayCommand(name, drone)) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN, "user", "a user who may command drones", "\"" + name + "\"");
        }
        return name;
    }

    private boolean mayCommand(String user, DroneId drone) {
        return access.user(user)
                .filter(User::isActive)
                .map(known -> Principal.of(
                        known, known.role(), KeyScope.ALL, null, grants.permissionsOf(known.organisation(), user)))
                .filter(known -> known.may(Role.OPERATOR, drone))
                .isPresent();
    }

    /** Nobody keeps control by rights that are gone. */
    private void judgeAnew() {
        // Before control is free: programs that steer would take it again at their next word.
        outlet.judgeAnew();
        cloud.controls().expelUnless(this::mayCommand);
    }
}
