package org.dronemap.ws.virtual;

import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.virtual.DroneChoice;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneObjection;
import org.dronemap.core.virtual.VirtualProgress;
import org.dronemap.core.virtual.VirtualRun;
import org.dronemap.core.virtual.VirtualRunAssignment;
import org.dronemap.core.virtual.VirtualRunStage;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.mission.MissionItemView;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ObjectionProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * Maps virtual drones to what clients see, once for all faces. What tells which drone serves one (its id and name, what it
 * or the gate says of it) goes only to who sees that drone. Any thread.
 */
public final class VirtualDroneViewMapper {
    private final CloudManager cloud;
    private final VirtualDrones virtuals;

    public VirtualDroneViewMapper(CloudManager cloud, VirtualDrones virtuals) {
        this.cloud = cloud;
        this.virtuals = virtuals;
    }

    public VirtualDroneView view(VirtualDrone drone, Principal principal) {
        return new VirtualDroneView(
                drone.id().value(),
                drone.name(),
                drone.owner(),
                DroneRequirementsReader.view(drone.needs()),
                drone.mission() == null
                        ? null
                        : MissionItemView.of(drone.mission().items()),
                drone.plan().upTo() == 1 ? null : (Integer) drone.plan().upTo(),
                drone.runs().isEmpty() ? null : run(drone, principal),
                drone.bound().stream().findFirst().flatMap(this::live).orElse(null),
                actions(drone, principal));
    }

    private VirtualDroneView.RunView run(VirtualDrone drone, Principal principal) {
        List<VirtualDroneView.ShareView> shares =
                drone.runs().stream().map(run -> share(drone, run, principal)).toList();
        VirtualProgress progress = VirtualProgress.of(drone.runs());
        VirtualDroneView.@Nullable ShareView only = shares.size() == 1 ? shares.get(0) : null;
        return new VirtualDroneView.RunView(
                WireNames.camel(progress.stage()),
                note(progress),
                virtuals.place(drone.id())
                        .map(place -> new VirtualDroneView.PlaceView(place.position(), place.length()))
                        .orElse(null),
                progress.flown(),
                progress.total(),
                drone.runs().get(0).onCloudLoss() == MissionCloudLossPolicy.CONTINUE ? "continue" : "rtl",
                progress.drones() == 0 ? null : (Integer) progress.drones(),
                only == null ? null : only.why(),
                only == null ? null : only.drone(),
                only == null ? null : only.detail(),
                shares,
                virtuals.waitingFor(drone.id()).stream()
                        .filter(unfit -> principal.sees(unfit.drone()))
                        .map(unfit -> new VirtualDroneView.UnfitView(
                                name(unfit.drone()),
                                unfit.why().sentence(),
                                unfit.why().code()))
                        .toList(),
                progress.changedAt().truncatedTo(ChronoUnit.MILLIS));
    }

    private VirtualDroneView.ShareView share(VirtualDrone drone, VirtualRun run, Principal principal) {
        DroneId bound = run.boundTo();
        VirtualRunAssignment assignment = run.assignment();
        return new VirtualDroneView.ShareView(
                WireNames.camel(run.stage()),
                run.note(),
                run.flown(),
                run.total(),
                assignment == null ? null : why(assignment.choice(), principal),
                bound == null || !principal.sees(bound) ? null : name(bound),
                maySeeDetail(drone, run, principal) ? run.detail() : null,
                bound == null ? null : live(bound).orElse(null));
    }

    private String note(VirtualProgress progress) {
        return progress.stage() == VirtualRunStage.QUEUED
                        && virtuals.warehouse().isEmpty()
                ? progress.sentence() + " There is none in the warehouse; a supervisor puts drones in."
                : progress.sentence();
    }

    private String why(DroneChoice choice, Principal principal) {
        return principal.sees(choice.chosen())
                ? choice.sentence(id -> principal.sees(id) ? "“" + name(id).name() + "”" : "another drone")
                : choice.anonymous();
    }

    /** It is about the drone that served last, which only who sees all that were tried can be sure to see. */
    private static boolean maySeeDetail(VirtualDrone drone, VirtualRun run, Principal principal) {
        boolean seesAllTried = Stream.concat(run.avoided().keySet().stream(), drone.recalled().stream())
                .allMatch(principal::sees);
        DroneId bound = run.boundTo();
        return seesAllTried && (bound == null ? principal.isWhole() : principal.sees(bound));
    }

    private VirtualDroneView.DroneName name(DroneId id) {
        return new VirtualDroneView.DroneName(
                id.value(), cloud.drone(id).map(DroneState::name).orElse(id.value()));
    }

    /** Where it is and how it flies is the user's own mission; who it is, is not among it. */
    private Optional<VirtualDroneView.LiveView> live(DroneId bound) {
        return cloud.drone(bound).map(state -> {
            Battery battery = state.battery();
            return new VirtualDroneView.LiveView(
                    WireNames.camel(state.link().state()),
                    WireNames.camel(state.identification().kind()),
                    state.armed(),
                    state.phase() == null ? null : WireNames.camel(state.phase()),
                    DroneViewMapper.position(state.position()),
                    DroneViewMapper.motion(state),
                    battery == null ? null : battery.percent());
        });
    }

    /** The same sentences serve the service and every page that greys a button. */
    private static Map<String, DroneView.ActionView> actions(VirtualDrone drone, Principal principal) {
        Map<String, DroneView.ActionView> actions = new LinkedHashMap<>();
        for (VirtualAction action : VirtualAction.values()) {
            actions.put(
                    WireNames.camel(action),
                    action.whyNot(drone, principal)
                            .map(DroneView.ActionView::forbidden)
                            .orElseGet(() -> DroneView.ActionView.allowedIn(null)));
        }
        return actions;
    }

    /** Actions on a virtual drone, each with the role that it needs. */
    enum VirtualAction {
        PLAN(Role.PLANNER),
        START(Role.OPERATOR),
        STOP(Role.OPERATOR),
        RESUME(Role.OPERATOR),
        REMOVE(Role.PLANNER);

        private final Role needed;

        VirtualAction(Role needed) {
            this.needed = needed;
        }

        Role needed() {
            return needed;
        }

        Optional<Rejection> whyNot(VirtualDrone drone, Principal principal) {
            return notAllowed(drone, principal)
                    .or(() -> stateForbids(drone)
                            .map(why ->
                                    ObjectionProblem.rejection(why, drone.id().value())));
        }

        /** Whatever state it is in. */
        private Optional<Rejection> notAllowed(VirtualDrone drone, Principal principal) {
            boolean own = drone.account().equals(principal.account());
            if (!own && this != STOP) {
                return Optional.of(Rejection.of(
                        AccessProblem.OWNER_ONLY,
                        "It belongs to " + drone.owner() + ".",
                        ProblemParameter.OWNER.is(drone.owner())));
            }
            return principal.mayVirtually(needed)
                    ? Optional.empty()
                    : Optional.of(Rejection.of(
                            AccessProblem.NOT_GRANTED, "Your role or key may not do this with virtual drones."));
        }

        private Optional<Objection> stateForbids(VirtualDrone drone) {
            return switch (this) {
                case PLAN -> Optional.empty();
                case START ->
                    drone.mission() == null
                            ? why(VirtualDroneObjection.NO_MISSION, "Plan its mission first.")
                            : drone.isUnderWay()
                                    ? why(VirtualDroneObjection.UNDER_WAY, "Its mission is under way already.")
                                    : Optional.empty();
                case STOP ->
                    drone.isUnderWay()
                            ? Optional.empty()
                            : why(VirtualDroneObjection.NOT_UNDER_WAY, "Its mission is not under way.");
                case RESUME ->
                    drone.runs().stream()
                                    .anyMatch(run -> run.stage() == VirtualRunStage.SUSPENDED
                                            || run.stage() == VirtualRunStage.FAILED)
                            ? Optional.empty()
                            : why(VirtualDroneObjection.NOT_SUSPENDED, "It does not wait for being resumed.");
                case REMOVE ->
                    drone.isUnderWay()
                            ? why(VirtualDroneObjection.UNDER_WAY, "Its mission is under way; stop it first.")
                            : Optional.empty();
            };
        }

        private static Optional<Objection> why(VirtualDroneObjection code, String sentence) {
            return Optional.of(Objection.of(code, sentence));
        }
    }
}
