package org.dronemap.ws.recovery;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.recovery.RecoveryDrone;
import org.dronemap.cognitive.operation.recovery.RecoveryInput;
import org.dronemap.cognitive.operation.recovery.RecoveryManner;
import org.dronemap.cognitive.operation.recovery.RecoveryOrder;
import org.dronemap.cognitive.operation.recovery.RecoveryPlan;
import org.dronemap.cognitive.operation.recovery.RecoveryPlanner;
import org.dronemap.cognitive.operation.recovery.RecoverySlot;
import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.cognitive.operation.recovery.RecoveryWait;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.time.Time;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.operation.OperationEnding;
import org.dronemap.ws.operation.OperationService;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.recovery.RecoverySelection.Chosen;
import org.jspecify.annotations.Nullable;

/** Lets users preview and begin recoveries, see how they go, and call them off. Any thread. */
public final class RecoveryService {
    private final Operations operations;
    private final OperationKind<RecoveryState, RecoveryInput> kind;
    private final OperationService<RecoveryState, RecoveryInput> desk;
    private final CloudManager cloud;
    private final Separation least;
    private final RecoveryTakeOver takeOver;

    /** Services that recoveries are conducted with; {@code least}: what is kept between any two drones. */
    public record OperationContext(
            Operations operations,
            OperationKind<RecoveryState, RecoveryInput> kind,
            CloudManager cloud,
            Separation least) {}

    /** Drones that were chosen, and their plan, from the state that they are in now. */
    private record Draft(RecoveryOrder order, Chosen chosen, RecoveryPlan plan) {}

    /** {@code endings}: by which other operations give up their drones. */
    public RecoveryService(OperationContext conduct, List<OperationEnding> endings, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.cloud = conduct.cloud();
        this.least = conduct.least();
        this.takeOver = new RecoveryTakeOver(conduct.cloud(), endings);
        desk = new OperationService<>(
                operations,
                kind,
                conduct.cloud(),
                new OperationService.Terms('c', "recovery", "a recovery flies", NotFoundProblem.RECOVERY),
                RecoveryService::isShownTo,
                time);
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<RecoveryView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return desk.all(principal).stream().map(this::view).toList();
    }

    public RecoveryView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return view(desk.find(principal, id));
    }

    public RecoveryPreview preview(Principal principal, RecoveryRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        Draft draft = draft(principal, request, null);
        Map<DroneId, RecoverySlot> slots = new HashMap<>();
        draft.plan().slots().forEach(slot -> slots.put(slot.drone(), slot));
        List<DroneState> ordered = new ArrayList<>();
        draft.plan().slots().forEach(slot -> cloud.drone(slot.drone()).ifPresent(ordered::add));
        draft.chosen().drones().stream()
                .filter(drone -> !slots.containsKey(drone.id()))
                .forEach(ordered::add);
        Function<DroneId, String> names =
                id -> cloud.drone(id).map(DroneState::name).orElse(id.value());
        return new RecoveryPreview(
                request.manner() == null ? "" : request.manner(),
                draft.order().lowestMeters(),
                draft.order().ceilingMeters(),
                draft.plan().slots().stream()
                        .mapToDouble(slot -> Math.round(slot.downSeconds()))
                        .max()
                        .orElse(0),
                ordered.stream()
                        .map(drone -> planned(drone, slots.get(drone.id()), names))
                        .toList(),
                draft.chosen().leftOut());
    }

    private static RecoveryPreview.PlannedView planned(
            DroneState drone, @Nullable RecoverySlot slot, Function<DroneId, String> names) {
        Geodetic here = slot == null ? RecoverySelection.point(drone) : slot.place();
        return new RecoveryPreview.PlannedView(
                drone.id().value(),
                drone.name(),
                here == null ? 0 : here.latitudeDegrees(),
                here == null ? 0 : here.longitudeDegrees(),
                RecoveryViewMapper.part(slot),
                slot == null
                        ? List.of()
                        : slot.waits().stream()
                                .map(RecoveryWait::other)
                                .distinct()
                                .map(names)
                                .toList());
    }

    /** {@code previewed}: drones that the user was shown; null: none was. */
    private Draft draft(Principal principal, RecoveryRequest request, @Nullable List<@Nullable String> previewed) {
        desk.requireWithoutBounds(principal);
        RecoveryOrder order = request.order(least);
        Chosen chosen = new RecoverySelection(cloud, principal, order, request.isTakeOver()).choose(request.drones());
        if (previewed != null) {
            requireSame(principal, new LinkedHashSet<>(previewed), chosen);
        }
        if (chosen.drones().isEmpty()) {
            throw Rejection.of(
                    OperationProblem.NO_DRONE_TO_RECOVER,
                    chosen.leftOut().isEmpty()
                            ? "No drone that you may command is in the air."
                            : "No drone can be brought " + (order.manner() == RecoveryManner.LAND ? "down" : "home")
                                    + " so. "
                                    + chosen.leftOut().stream()
                                            .map(one -> one.droneName() + ": " + one.why())
                                            .collect(Collectors.joining(" ")));
        }
        if (chosen.drones().size() > RecoveryOrder.MOST_DRONES) {
            throw Rejection.of(
                    OperationProblem.RECOVERY_DOES_NOT_FIT,
                    chosen.drones().size() + " drones are too many for one recovery; it brings home at most "
                            + RecoveryOrder.MOST_DRONES + ". Name fewer.",
                    ProblemParameter.DRONES.is(chosen.drones().size()),
                    ProblemParameter.MOST.is(RecoveryOrder.MOST_DRONES));
        }
        return new Draft(order, chosen, plan(order, chosen));
    }

    /** Nobody confirms what was not shown. */
    private void requireSame(Principal principal, Set<@Nullable String> previewed, Chosen chosen) {
        List<String> more = chosen.drones().stream()
                .filter(drone -> !previewed.contains(drone.id().value()))
                .map(DroneState::name)
                .toList();
        List<String> gone = previewed.stream()
                .map(String::valueOf)
                .filter(id -> chosen.drones().stream()
                        .noneMatch(drone -> drone.id().value().equals(id)))
                .map(id -> whyGone(principal, id, chosen))
                .toList();
        if (!more.isEmpty() || !gone.isEmpty()) {
            throw Rejection.of(
                    OperationProblem.RECOVERY_CHANGED,
                    (more.isEmpty()
                                    ? ""
                                    : "Since the preview more drones would come: " + String.join(", ", more) + ". ")
                            + (gone.isEmpty() ? "" : "Since the preview fewer drones would come. ")
                            + String.join("", gone)
                            + "Look at a new preview.");
        }
    }

    private String whyGone(Principal principal, String id, Chosen chosen) {
        Optional<String> leftOut = chosen.leftOut().stream()
                .filter(one -> one.drone().equals(id))
                .map(one -> one.droneName() + ": " + one.why() + " ")
                .findFirst();
        return leftOut.orElseGet(() -> cloud.drones().stream()
                        .filter(drone -> drone.id().value().equals(id) && principal.sees(drone.id()))
                        .map(DroneState::name)
                        .findFirst()
                        .orElse(id)
                + " is not in the air. ");
    }

    private static RecoveryPlan plan(RecoveryOrder order, Chosen chosen) {
        List<RecoveryDrone> standing = chosen.standing();
        if (standing.isEmpty()) {
            return new RecoveryPlan(List.of(), 0, null);
        }
        RecoveryPlan plan = RecoveryPlanner.plan(order, standing);
        if (plan.why() != null) {
            throw Rejection.of(
                    OperationProblem.RECOVERY_DOES_NOT_FIT,
                    plan.why(),
                    ProblemParameter.DRONES.is(standing.size()),
                    ProblemParameter.MOST.is(plan.fitting()));
        }
        return plan;
    }

    /** All stop at once, and come in their turns. */
    public RecoveryView begin(Principal principal, RecoveryRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        Draft draft = draft(principal, request, request.previewed());
        desk.requireRoom(principal);
        takeOver.free(principal, draft.order().manner(), draft.chosen().drones());
        Instant at = desk.now();
        OperationId id = desk.newId();
        List<RecoveryState.Member> members = draft.chosen().drones().stream()
                .map(drone -> new RecoveryState.Member(
                        drone.id(), drone.name(), draft.chosen().highest(drone.id())))
                .toList();
        String name = draft.order().manner() == RecoveryManner.LAND ? "Land all" : "Return all";
        return view(desk.begin(principal, id, name, RecoveryState.begin(id, draft.order(), members, at), at));
    }

    /** Whoever asked for it gets its drones, which hold. */
    public RecoveryView cancel(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        Snapshot<RecoveryState> recovery = desk.find(principal, id);
        desk.requireWithoutBounds(principal);
        boolean own = recovery.saved().account().equals(principal.account());
        boolean may = recovery.state().legs().stream().allMatch(leg -> principal.may(Role.SUPERVISOR, leg.drone()));
        if (!own && !may) {
            throw Rejection.of(
                    AccessProblem.OWNER_ONLY,
                    "Only " + recovery.saved().owner() + " or a supervisor calls that recovery off.",
                    ProblemParameter.OWNER.is(recovery.saved().owner()));
        }
        return view(desk.submit(recovery, new RecoveryInput.Cancel(desk.now(), principal.name())));
    }

    /** Hears of recoveries and of all other operations. */
    public void addListener(OperationListener listener) {
        operations.addListener(listener);
    }

    /** Those under way. */
    public List<Snapshot<RecoveryState>> underWay() {
        return operations.underWay(kind);
    }

    /** As it was stored; empty: it is another kind of operation. */
    public Optional<Snapshot<RecoveryState>> picture(SavedOperation saved) {
        return desk.picture(saved);
    }

    public RecoveryView view(Snapshot<RecoveryState> recovery) {
        return RecoveryViewMapper.view(recovery, desk.now());
    }

    /** Its sentences name all drones of it. */
    public static boolean isShownTo(Principal principal, Snapshot<RecoveryState> recovery) {
        return principal.organisation().equals(recovery.saved().organisation())
                && (recovery.saved().account().equals(principal.account())
                        || recovery.state().legs().stream().allMatch(leg -> principal.sees(leg.drone())));
    }
}
