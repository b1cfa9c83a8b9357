package org.dronemap.ws.run;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.Time;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.operation.OperationService;
import org.dronemap.ws.plan.PlanDroneFactory;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.zone.ZoneFeature;

/**
 * Lets users start, watch, change and stop a mission run, and answer its proposals of re-planning. Shared by those who
 * may command all of its drones. Any thread.
 */
public final class RunService {
    private final Operations operations;
    private final OperationKind<RunState, RunInput> kind;
    private final PlanService plans;
    private final DroneService drones;
    private final OperationService<RunState, RunInput> desk;

    /** Services that mission runs are conducted with. */
    public record OperationContext(Operations operations, OperationKind<RunState, RunInput> kind, CloudManager cloud) {}

    public RunService(OperationContext conduct, PlanService plans, DroneService drones, Time time) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.plans = plans;
        this.drones = drones;
        desk = new OperationService<>(
                operations,
                kind,
                conduct.cloud(),
                new OperationService.Terms('r', "mission run", "a mission run flies", NotFoundProblem.MISSION_RUN),
                RunService::isShownTo,
                time);
    }

    /** For others it does not exist. */
    public static boolean isShownTo(Principal principal, Snapshot<RunState> run) {
        return principal.organisation().equals(run.saved().organisation())
                && run.state().drones().stream().allMatch(drone -> principal.sees(drone.id()));
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<RunView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return desk.all(principal).stream().map(RunViewMapper::view).toList();
    }

    public RunView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return RunViewMapper.view(find(principal, id));
    }

    /** Everybody's that are under way, for who shows them. */
    public List<Snapshot<RunState>> underWay() {
        return operations.underWay(kind);
    }

    /** As it was stored, for who shows it; empty: it is another kind of operation. */
    public Optional<Snapshot<RunState>> picture(SavedOperation saved) {
        return desk.picture(saved);
    }

    /** Hears of all operations. */
    public void addListener(OperationListener listener) {
        operations.addListener(listener);
    }

    /** Takes control of the plan's drones and has them fly it; from then on the cloud conducts it. */
    public RunView start(Principal principal, RunRequest.StartRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        desk.requireWithoutBounds(principal);
        if (request.plan() == null) {
            throw InvalidInput.missing("plan", "the id of a plan");
        }
        String name = RunReader.name(request);
        RunOrder.ApprovalMode mode = RunReader.mode(request.mode());
        Duration search = RunReader.search(request.searchSeconds());
        desk.requireRoom(principal);
        PlanService.Flyable plan = plans.flyable(principal, request.plan());
        Instant at = desk.now();
        OperationId id = desk.newId();
        RunOrder order = new RunOrder(
                id,
                plan.order().problem(),
                plan.planned().plan(),
                plan.order().drones().stream().map(RunService::member).toList(),
                mode,
                RunReader.onCloudLoss(request.onCloudLoss()),
                plan.order().seed(),
                search,
                at,
                plan.order().upTo());
        RunState state = RunState.begin(order);
        return RunViewMapper.view(desk.begin(principal, id, name, state, at));
    }

    private static RunOrder.Member member(DroneState drone) {
        return new RunOrder.Member(
                drone.id(), drone.name(), drone.identification().kind());
    }

    public RunView add(Principal principal, String id, RunRequest.WaypointsRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).added(run, request));
    }

    public RunView move(Principal principal, String id, String waypoint, RunRequest.MoveRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).moved(run, target(run, waypoint), request));
    }

    public RunView cancel(Principal principal, String id, String waypoint) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).cancelled(target(run, waypoint)));
    }

    public RunView bar(Principal principal, String id, ZoneFeature feature) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).barrier(feature));
    }

    public RunView join(Principal principal, String id, RunRequest.JoinRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> {
            if (request.drone() == null) {
                throw InvalidInput.missing("drone", "the id of a drone");
            }
            DroneState drone = drones.state(principal, request.drone(), Role.OPERATOR);
            RunInput wish = reader(principal).joined(PlanDroneFactory.of(drone), drone);
            desk.releaseControl(principal, drone.id());
            return wish;
        });
    }

    /** The only way in which a drone that somebody took comes back to its run. */
    public RunView resume(Principal principal, String id, String drone) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> {
            DroneId known = drone(run, drone);
            RunInput resumed = reader(principal).resumed(known);
            desk.releaseForRequest(principal, id, run, resumed, known);
            return resumed;
        });
    }

    public RunView giveUp(Principal principal, String id, String drone) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).givenUp(drone(run, drone)));
    }

    public RunView answer(Principal principal, String id, String proposal, RunRequest.AnswerRequest request) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).answered(proposal, request));
    }

    /** Its drones wait where they are. */
    public RunView pause(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).paused());
    }

    public RunView goOn(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).wentOn());
    }

    public RunView stop(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        return submit(principal, id, run -> reader(principal).stopped());
    }

    private RunReader reader(Principal principal) {
        return new RunReader(principal.name(), desk.now());
    }

    private RunView submit(Principal principal, String id, Function<RunState, RunInput> what) {
        Snapshot<RunState> run = find(principal, id);
        desk.requireWithoutBounds(principal);
        for (RunDrone drone : run.state().drones()) {
            RoleChecks.require(principal, Role.OPERATOR, drone.id());
        }
        if (run.saved().endedAt() != null) {
            throw desk.over(id);
        }
        RunInput input = what.apply(run.state());
        return RunViewMapper.view(desk.submit(run, input));
    }

    private static RunWaypoint target(RunState run, String id) {
        return run.target(id).orElseThrow(() -> Rejection.unknown(NotFoundProblem.WAYPOINT, id));
    }

    private static DroneId drone(RunState run, String id) {
        return run.drones().stream()
                .map(RunDrone::id)
                .filter(drone -> drone.value().equals(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, id));
    }

    Snapshot<RunState> find(Principal principal, String id) {
        return desk.find(principal, id);
    }
}
