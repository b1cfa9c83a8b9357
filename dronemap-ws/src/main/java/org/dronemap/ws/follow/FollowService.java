package org.dronemap.ws.follow;

import java.time.Instant;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.cognitive.operation.follow.FollowStage;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.conduct.TargetReportResult;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.time.Time;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationService;
import org.dronemap.ws.operation.PoolDroneSelector;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;

/** Lets users open, start, pause, change and stop follows, and takes in the positions of their phones. Any thread. */
public final class FollowService {
    private static final Set<Capability> NEEDS =
            Set.of(Capability.TAKE_OFF, Capability.TRACK, Capability.RETURN_TO_LAUNCH);

    private final Operations operations;
    private final OperationKind<FollowState, FollowInput> kind;
    private final OperationService<FollowState, FollowInput> desk;
    private final PoolDroneSelector drones;
    private final FollowViewMapper views;
    private final DronePool warehouse;

    /** Services that follows are conducted with. */
    public record OperationContext(
            Operations operations, OperationKind<FollowState, FollowInput> kind, CloudManager cloud) {}

    public FollowService(OperationContext conduct, DronePool warehouse, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.drones = new PoolDroneSelector(conduct.cloud());
        this.views = new FollowViewMapper(conduct);
        this.warehouse = warehouse;
        desk = new OperationService<>(
                operations,
                kind,
                conduct.cloud(),
                new OperationService.Terms('f', "follow", "a follow flies", NotFoundProblem.FOLLOW),
                FollowService::isShownTo,
                time);
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<FollowView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return desk.all(principal).stream().map(views::view).toList();
    }

    public FollowView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return views.view(desk.find(principal, id));
    }

    /** A drone is chosen and kept for it; it stays on the ground until it is started. */
    public FollowView open(Principal principal, FollowRequest.OpenRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        desk.requireWithoutBounds(principal);
        List<DroneState> candidates = candidates(principal, request);
        String name = FollowReader.name(request);
        Geodetic near = FollowReader.near(request);
        FollowOrder.RelativePlace place = FollowReader.place(request);
        PoolDroneSelector.Task task = task(near, place, FollowReader.minutes(request));
        double speed = FollowReader.speed(request);
        int patience = FollowReader.patience(request);
        desk.requireRoom(principal);
        Instant at = desk.now();
        ChosenDrone chosen = choose(principal, candidates, task, at);
        FollowOrder order = new FollowOrder(chosen, near, place, speed, patience);
        OperationId id = desk.newId();
        FollowState state = FollowState.begin(id, order, at);
        return views.view(desk.begin(principal, id, name, state, at));
    }

    /** Among these; a conflict with why each cannot when none can. */
    private ChosenDrone choose(
            Principal principal, List<DroneState> candidates, PoolDroneSelector.Task task, Instant at) {
        PoolDroneSelector.Found found = drones.find(principal, candidates, task, at);
        return found.chosen()
                .orElseThrow(() -> Rejection.of(
                        OperationProblem.NO_DRONE_TO_FOLLOW,
                        candidates.isEmpty()
                                ? "The warehouse has no drone that you may command. Name one that you look after."
                                : "No drone can follow now. " + found.why()));
    }

    /** Come, stay for so long, return home. */
    static PoolDroneSelector.Task task(Geodetic near, FollowOrder.RelativePlace place, double minutes) {
        return new PoolDroneSelector.Task(near, place.heightMeters(), minutes, NEEDS);
    }

    private List<DroneState> candidates(Principal principal, FollowRequest.OpenRequest request) {
        List<DroneState> all = drones.commandable(principal);
        String wanted = request.drone();
        if (wanted == null) {
            // Nobody looks after one that the cloud chooses.
            Set<DroneId> waiting = warehouse.drones();
            return all.stream().filter(drone -> waiting.contains(drone.id())).toList();
        }
        return List.of(all.stream()
                .filter(drone -> drone.id().value().equals(wanted))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, wanted)));
    }

    public FollowView start(Principal principal, String id) {
        return submit(principal, id, (by, at) -> new FollowInput.Start(at, by));
    }

    public FollowView cancel(Principal principal, String id) {
        return submit(principal, id, (by, at) -> new FollowInput.Cancel(at, by));
    }

    public FollowView pause(Principal principal, String id) {
        return submit(principal, id, (by, at) -> new FollowInput.Pause(at, by));
    }

    /** The only way in which a drone that somebody took comes back to its follow. */
    public FollowView goOn(Principal principal, String id) {
        return submit(principal, id, (by, at) -> new FollowInput.Resume(at, by), true);
    }

    /** A drone that nobody has any more, and that stands in the air, is taken for that. */
    public FollowView stop(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        Snapshot<FollowState> follow = desk.find(principal, id);
        if (follow.state().stage() == FollowStage.SUSPENDED
                && drones.isLeftAloft(follow.state().drone())) {
            goOn(principal, id);
        }
        return submit(principal, id, (by, at) -> new FollowInput.Stop(at, by));
    }

    public FollowView change(Principal principal, String id, FollowRequest.PlaceRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        FollowOrder.RelativePlace place = FollowReader.place(
                request, desk.find(principal, id).state().order().place(), "");
        return submit(principal, id, (by, at) -> new FollowInput.ChangePlace(at, by, place));
    }

    /** Where the phone is; whoever asked to be followed says that, and nobody else. */
    public FollowReceipt positions(Principal principal, String id, FollowRequest.PositionsRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        Snapshot<FollowState> follow = desk.find(principal, id);
        if (!follow.saved().account().equals(principal.account())) {
            throw Rejection.of(
                    AccessProblem.OWNER_ONLY,
                    "Only " + follow.saved().owner() + " says where the phone is.",
                    ProblemParameter.OWNER.is(follow.saved().owner()));
        }
        // Where the phone is said to be, there the drone flies.
        desk.requireWithoutBounds(principal);
        RoleChecks.require(principal, Role.OPERATOR, follow.state().drone());
        FollowReceipt.Count count = new FollowReceipt.Count();
        for (TargetReport sighting : FollowReader.sightings(request, desk.now())) {
            TargetReportResult reception =
                    operations.reported(kind, follow.saved().id(), sighting);
            if (reception == TargetReportResult.NOT_EXPECTED) {
                throw desk.over(id);
            }
            if (!count.add(sighting.number(), reception)) {
                break;
            }
        }
        return count.receipt(follow.saved().id().value(), desk.now());
    }

    /** Hears of follows and of all other operations. */
    public void addListener(OperationListener listener) {
        operations.addListener(listener);
    }

    /** How its phone is reached from now on; false when it is not under way. */
    public boolean reached(String id, ReporterState how) {
        return operations.reporterStateChanged(kind, new OperationId(id), how);
    }

    /** Where the phone is at this moment, for those who say it with nothing between. */
    public void isAt(Principal principal, String id, FollowRequest.PositionRequest where) {
        Instant now = desk.now();
        FollowRequest.PositionRequest here = new FollowRequest.PositionRequest(
                null, now, where.latitude(), where.longitude(), where.accuracy(), where.speed(), where.course());
        FollowReceipt receipt = positions(
                principal, id, new FollowRequest.PositionsRequest(now, null, Collections.singletonList(here)));
        if (receipt.upTo() == null) {
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY,
                    "The server is busy; say again where the phone is.",
                    ProblemParameter.WHAT.is("positions"));
        }
    }

    /** Those under way. */
    public List<Snapshot<FollowState>> underWay() {
        return operations.underWay(kind);
    }

    /** As it was stored; empty: it is another kind of operation. */
    public Optional<Snapshot<FollowState>> picture(SavedOperation saved) {
        return desk.picture(saved);
    }

    public FollowView view(Snapshot<FollowState> follow) {
        return views.view(follow);
    }

    public static boolean isShownTo(Principal principal, Snapshot<FollowState> follow) {
        return principal.organisation().equals(follow.saved().organisation())
                && principal.sees(follow.state().drone());
    }

    private FollowView submit(Principal principal, String id, BiFunction<String, Instant, FollowInput> what) {
        return submit(principal, id, what, false);
    }

    /** {@code hands}: control that the user has of the drone goes over to the follow, once nothing speaks against the wish. */
    private FollowView submit(
            Principal principal, String id, BiFunction<String, Instant, FollowInput> what, boolean hands) {
        RoleChecks.require(principal, Role.OPERATOR);
        Snapshot<FollowState> follow = desk.find(principal, id);
        desk.requireWithoutBounds(principal);
        RoleChecks.require(principal, Role.OPERATOR, follow.state().drone());
        if (follow.saved().endedAt() != null) {
            throw desk.over(id);
        }
        FollowInput input = what.apply(principal.name(), desk.now());
        if (hands) {
            desk.releaseForRequest(
                    principal, id, follow.state(), input, follow.state().drone());
        }
        return views.view(desk.submit(follow, input));
    }
}
