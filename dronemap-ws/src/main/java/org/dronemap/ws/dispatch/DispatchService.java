package org.dronemap.ws.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.dispatch.DispatchInput;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg;
import org.dronemap.cognitive.operation.dispatch.DispatchOrder;
import org.dronemap.cognitive.operation.dispatch.DispatchStage;
import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.Time;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationService;
import org.dronemap.ws.operation.PoolDroneSelector;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;

/** Lets users send a drone of the pool to a place, see how it comes, and call it off. Any thread. */
public final class DispatchService {
    private static final String NAME = "Send a drone here";
    /** Another user may be given the best one in the same moment. */
    private static final int MOST_CHOICES = 5;

    private static final Set<Capability> NEEDS =
            Set.of(Capability.TAKE_OFF, Capability.GO_TO, Capability.HOLD, Capability.RETURN_TO_LAUNCH);

    private final Operations operations;
    private final OperationKind<DispatchState, DispatchInput> kind;
    private final OperationService<DispatchState, DispatchInput> desk;
    private final PoolDroneSelector drones;
    private final DispatchViewMapper views;
    private final DronePool pool;

    /** Services that dispatches are conducted with. */
    public record OperationContext(
            Operations operations, OperationKind<DispatchState, DispatchInput> kind, CloudManager cloud) {}

    public DispatchService(OperationContext conduct, DronePool pool, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.drones = new PoolDroneSelector(conduct.cloud());
        this.views = new DispatchViewMapper(conduct.cloud());
        this.pool = pool;
        desk = new OperationService<>(
                operations,
                kind,
                conduct.cloud(),
                new OperationService.Terms('d', "dispatch", "a drone that is sent flies", NotFoundProblem.DISPATCH),
                DispatchService::isShownTo,
                time);
    }

    /** Come, stay for so long, return home. */
    static PoolDroneSelector.Task task(DispatchOrder order, double minutes) {
        return new PoolDroneSelector.Task(order.place(), order.heightMeters(), minutes, NEEDS);
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<DispatchView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return desk.all(principal).stream().map(views::view).toList();
    }

    public DispatchView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return views.view(desk.find(principal, id));
    }

    /** The best free drone is chosen, and starts at once. */
    public DispatchView send(Principal principal, DispatchRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        desk.requireWithoutBounds(principal);
        DispatchOrder order = request.order();
        PoolDroneSelector.Task task = task(order, request.stayMinutes());
        desk.requireRoom(principal);
        for (int choice = 1; choice < MOST_CHOICES; choice++) {
            try {
                return begin(principal, order, task);
            } catch (Rejection held) {
                if (!held.code().equals(new CommandProblem(OutcomeCode.CONTROL_HELD))) {
                    throw held;
                }
            }
        }
        return begin(principal, order, task);
    }

    private DispatchView begin(Principal principal, DispatchOrder order, PoolDroneSelector.Task task) {
        Instant at = desk.now();
        ChosenDrone chosen = choose(principal, task, at);
        OperationId id = desk.newId();
        return views.view(desk.begin(principal, id, NAME, DispatchState.begin(id, order, chosen, at), at));
    }

    private ChosenDrone choose(Principal principal, PoolDroneSelector.Task task, Instant at) {
        List<DroneState> candidates = candidates(drones, pool, principal);
        PoolDroneSelector.Found found = drones.find(principal, candidates, task, at);
        return found.chosen()
                .orElseThrow(() -> Rejection.of(
                        OperationProblem.NO_DRONE_TO_SEND,
                        candidates.isEmpty()
                                ? "The pool has no drone that you may command."
                                : "No drone can come now. " + found.why()));
    }

    /** Nobody looks after one that the cloud chooses. */
    static List<DroneState> candidates(PoolDroneSelector drones, DronePool pool, Principal principal) {
        Set<DroneId> waiting = pool.drones();
        return drones.commandable(principal).stream()
                .filter(drone -> waiting.contains(drone.id()))
                .toList();
    }

    /** Whatever flies for it comes home, also when its owner has control by now. */
    public DispatchView cancel(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        Snapshot<DispatchState> dispatch = desk.find(principal, id);
        desk.requireWithoutBounds(principal);
        if (!dispatch.saved().account().equals(principal.account()) && !mayCallOff(principal, dispatch.state())) {
            throw Rejection.of(
                    AccessProblem.OWNER_ONLY,
                    "Only " + dispatch.saved().owner() + " calls that drone off now.",
                    ProblemParameter.OWNER.is(dispatch.saved().owner()));
        }
        DispatchInput wish = new DispatchInput.Cancel(desk.now(), principal.name());
        DispatchLeg lead = dispatch.state().lead();
        if (lead != null && dispatch.state().stage() == DispatchStage.HERE) {
            desk.releaseForRequest(principal, id, dispatch.state(), wish, lead.drone());
        }
        return views.view(desk.submit(dispatch, wish));
    }

    /** Others do as long as nobody has the drone in hand. */
    private static boolean mayCallOff(Principal principal, DispatchState state) {
        return state.stage() != DispatchStage.HERE
                && drones(state).allMatch(drone -> principal.may(Role.OPERATOR, drone));
    }

    /** Hears of dispatches and of all other operations. */
    public void addListener(OperationListener listener) {
        operations.addListener(listener);
    }

    /** Those under way. */
    public List<Snapshot<DispatchState>> underWay() {
        return operations.underWay(kind);
    }

    /** As it was stored; empty: it is another kind of operation. */
    public Optional<Snapshot<DispatchState>> picture(SavedOperation saved) {
        return desk.picture(saved);
    }

    public DispatchView view(Snapshot<DispatchState> dispatch) {
        return views.view(dispatch);
    }

    /** Its sentences name all drones of it. */
    public static boolean isShownTo(Principal principal, Snapshot<DispatchState> dispatch) {
        return principal.organisation().equals(dispatch.saved().organisation())
                && (dispatch.saved().account().equals(principal.account())
                        || drones(dispatch.state()).allMatch(principal::sees));
    }

    private static Stream<DroneId> drones(DispatchState state) {
        return Stream.concat(
                Stream.concat(Stream.ofNullable(state.lead()), state.returning().stream())
                        .map(DispatchLeg::drone),
                state.failed().stream());
    }
}
