package org.dronemap.ws.service;

import java.util.concurrent.CompletionException;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantBook;
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
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Use cases around who commands a drone: take, ask, grant, hand over, give back. Any thread. */
public final class ControlService {
    private static final Logger LOG = LoggerFactory.getLogger(ControlService.class);
    static final int LONGEST_REASON = 200;

    private final CloudManager cloud;
    private final DroneService drones;
    private final AccessStore access;
    private final GrantBook grants;
    private final OutletControl outlet;

    /** How it is now; {@code waiting}: the holder was asked, and decides. */
    public record Answer(ControlView control, boolean waiting) {}

    public ControlService(
            CloudManager cloud,
            DroneService drones,
            AccessStore access,
            Accounts accounts,
            GrantBook grants,
            OutletControl outlet) {
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
    public Answer act(Principal principal, String droneId, ControlAction action, ControlRequestView with) {
        DroneState drone = drone(principal, droneId, action);
        if (drone.replay()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    "This is a recording; it cannot be commanded.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        LeaseStep step = apply(drone.id(), event(principal.name(), action, with, drone.id()));
        if (step.answer() instanceof LeaseAnswer.Denied denied) {
            throw Rejection.held(denied.why(), drone.id(), step.control());
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

    private LeaseStep apply(DroneId drone, LeaseEvent event) {
        try {
            return cloud.controls().apply(drone, event);
        } catch (UnknownDroneException removedMeanwhile) {
            throw Rejection.unknown(UnknownProblem.DRONE, drone.value());
        } catch (CompletionException notWritten) {
            LOG.warn("A change of who has control of {} could not be written down", drone, notWritten);
            throw Rejection.of(
                    ServerProblem.CHANGE_NOT_KEPT,
                    "Control has changed as you asked, but that could not be written down: should the server be started"
                            + " anew now, it may be as it was before.");
        }
    }

    private LeaseEvent event(String user, ControlAction action, ControlRequestView with, DroneId drone) {
        return switch (action) {
            case TAKE -> new LeaseEvent.Take(user);
            case REQUEST -> new LeaseEvent.Request(user, reason(with.reason()));
            case GRANT -> new LeaseEvent.Grant(user, pilot(with.user(), drone));
            case REFUSE -> new LeaseEvent.Refuse(user, named(with.user()), reason(with.reason()));
            case HAND_OVER -> new LeaseEvent.HandOver(user, pilot(with.user(), drone));
            case TAKE_OVER -> new LeaseEvent.TakeOver(user, Names.checked("reason", with.reason(), LONGEST_REASON));
            case HEARTBEAT -> new LeaseEvent.Heartbeat(user, epoch(with.epoch()));
            case RELEASE -> new LeaseEvent.Release(user);
        };
    }

    private static @Nullable String reason(@Nullable String given) {
        return given == null || given.isBlank() ? null : Names.checked("reason", given, LONGEST_REASON);
    }

    private static long epoch(@Nullable Long given) {
        if (given == null) {
            throw InvalidInput.missing("epoch", "the one that taking control was answered with");
        }
        return given;
    }

    private static String named(@Nullable String user) {
        if (user == null || user.isBlank()) {
            throw InvalidInput.missing("user", "the name of a user");
        }
        return user.strip();
    }

    /** Control goes to nobody who may not command. */
    private String pilot(@Nullable String user, DroneId drone) {
        String name = named(user);
        if (!mayCommand(name, drone)) {
            throw InvalidInput.outside(
                    ValueProblem.REFERENCE_UNKNOWN, "user", "a user who may command drones", "\"" + name + "\"");
        }
        return name;
    }

    private boolean mayCommand(String user, DroneId drone) {
        return access.user(user)
                .filter(User::isActive)
                .map(known ->
                        Principal.of(known, known.role(), KeyScope.ALL, null, grants.reach(known.organisation(), user)))
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
