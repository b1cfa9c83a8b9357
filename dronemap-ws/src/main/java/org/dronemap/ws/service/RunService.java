package org.dronemap.ws.service;

import java.security.SecureRandom;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dronemap.cognitive.operation.run.RunDrone;
import org.dronemap.cognitive.operation.run.RunInput;
import org.dronemap.cognitive.operation.run.RunOrder;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.Target;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;

/** Use cases around mission runs: start, look, change, answer, stop. Shared by those who may command all of its drones. Any thread. */
public final class RunService {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int ID_LENGTH = 16;
    private static final int MOST_UNDER_WAY = 50;
    private static final int MOST_LISTED = 50;
    private static final Comparator<Picture<RunState>> NEWEST_FIRST = Comparator.comparing(
                    (Picture<RunState> run) -> run.saved().beganAt())
            .reversed();

    private final Operations operations;
    private final OperationKind<RunState, RunInput> kind;
    private final PlanService plans;
    private final DroneService drones;
    private final CloudManager cloud;
    private final Clock clock;
    private final SecureRandom random = new SecureRandom();

    /** What runs are conducted by. */
    public record Conduct(Operations operations, OperationKind<RunState, RunInput> kind, CloudManager cloud) {}

    public RunService(Conduct conduct, PlanService plans, DroneService drones, Clock clock) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.cloud = conduct.cloud();
        this.plans = plans;
        this.drones = drones;
        this.clock = clock;
    }

    /** For others it does not exist. */
    public static boolean isShownTo(Principal principal, Picture<RunState> run) {
        return principal.organisation().equals(run.saved().organisation())
                && run.state().drones().stream().allMatch(drone -> principal.sees(drone.id()));
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<RunView> all(Principal principal) {
        Roles.require(principal, Role.VIEWER);
        List<Picture<RunState>> runs = new ArrayList<>(operations.underWay(kind));
        operations.latest(principal.organisation(), MOST_LISTED).stream()
                .filter(saved -> saved.endedAt() != null)
                .flatMap(saved -> picture(saved).stream())
                .forEach(runs::add);
        return runs.stream()
                .filter(run -> isShownTo(principal, run))
                .sorted(NEWEST_FIRST)
                .map(RunViews::view)
                .toList();
    }

    public RunView one(Principal principal, String id) {
        Roles.require(principal, Role.VIEWER);
        return RunViews.view(find(principal, id));
    }

    /** Everybody's that are under way, for who shows them. */
    public List<Picture<RunState>> underWay() {
        return operations.underWay(kind);
    }

    /** As it was stored, for who shows it; empty: it is another kind of operation. */
    public Optional<Picture<RunState>> picture(SavedOperation saved) {
        return saved.kind().equals(kind.name())
                ? Optional.of(new Picture<>(saved, kind.codec().state(saved.state())))
                : Optional.empty();
    }

    /** Hears of all operations. */
    public void addListener(OperationListener listener) {
        operations.addListener(listener);
    }

    /** Takes control of the plan's drones and has them fly it; from then on the cloud conducts it. */
    public RunView start(Principal principal, RunRequest.StartRequest request) {
        Roles.require(principal, Role.OPERATOR);
        requireWithoutBounds(principal);
        if (request.plan() == null) {
            throw InvalidInput.missing("plan", "the id of a plan");
        }
        String name = RunReader.name(request);
        RunOrder.Mode mode = RunReader.mode(request.mode());
        requireRoom(principal);
        PlanService.Flyable plan = plans.flyable(principal, request.plan());
        Instant at = now();
        OperationId id = newId();
        RunOrder order = new RunOrder(
                id,
                plan.order().problem(),
                plan.planned().plan(),
                plan.order().drones().stream().map(RunService::member).toList(),
                mode,
                RunReader.onCloudLoss(request.onCloudLoss()),
                plan.order().seed(),
                RunReader.search(request.searchSeconds()),
                at);
        RunState state = RunState.begin(order);
        kind.machine().drones(state).forEach(drone -> giveBack(principal, drone));
        SavedOperation begun = SavedOperation.begun(
                id, kind.name(), new SavedOperation.Owner(principal.name(), principal.organisation()), name, at);
        return RunViews.view(conducted(() -> operations.begin(kind, begun, state)));
    }

    private static RunOrder.Member member(DroneState drone) {
        return new RunOrder.Member(
                drone.id(), drone.name(), drone.identification().kind());
    }

    /** What a user has in hand goes over to the run that the same user starts. */
    private void giveBack(Principal principal, DroneId drone) {
        if (cloud.controls().control(drone).isHeldBy(principal.name())) {
            cloud.controls().apply(drone, new LeaseEvent.Release(principal.name()));
        }
    }

    private void requireRoom(Principal principal) {
        long underWay = operations.underWay(kind).stream()
                .filter(run -> run.saved().organisation().equals(principal.organisation()))
                .count();
        if (underWay >= MOST_UNDER_WAY) {
            throw Rejection.conflict("Your organisation has " + underWay + " mission runs under way already.");
        }
    }

    public RunView add(Principal principal, String id, RunRequest.WaypointsRequest request) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).added(run, request));
    }

    public RunView move(Principal principal, String id, String waypoint, RunRequest.MoveRequest request) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).moved(run, target(run, waypoint), request));
    }

    public RunView cancel(Principal principal, String id, String waypoint) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).cancelled(target(run, waypoint)));
    }

    public RunView bar(Principal principal, String id, ZoneFeature feature) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).barrier(feature));
    }

    public RunView join(Principal principal, String id, RunRequest.JoinRequest request) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> {
            if (request.drone() == null) {
                throw InvalidInput.missing("drone", "the id of a drone");
            }
            DroneState drone = drones.state(principal, request.drone(), Role.OPERATOR);
            RunInput wish = reader(principal).joined(PlanCrafts.of(drone), drone);
            giveBack(principal, drone.id());
            return wish;
        });
    }

    /** The only way in which a drone that somebody took comes back to its run. */
    public RunView resume(Principal principal, String id, String drone) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> {
            DroneId known = drone(run, drone);
            giveBack(principal, known);
            return reader(principal).resumed(known);
        });
    }

    public RunView giveUp(Principal principal, String id, String drone) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).givenUp(drone(run, drone)));
    }

    public RunView answer(Principal principal, String id, String proposal, RunRequest.AnswerRequest request) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).answered(proposal, request));
    }

    /** Its drones wait where they are. */
    public RunView pause(Principal principal, String id) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).paused());
    }

    public RunView goOn(Principal principal, String id) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).wentOn());
    }

    public RunView stop(Principal principal, String id) {
        Roles.require(principal, Role.OPERATOR);
        return wish(principal, id, run -> reader(principal).stopped());
    }

    private RunReader reader(Principal principal) {
        return new RunReader(principal.name(), now());
    }

    private RunView wish(Principal principal, String id, Function<RunState, RunInput> what) {
        Picture<RunState> run = find(principal, id);
        requireWithoutBounds(principal);
        for (RunDrone drone : run.state().drones()) {
            Roles.require(principal, Role.OPERATOR, drone.id());
        }
        if (run.saved().endedAt() != null) {
            throw Rejection.conflict("This mission run is over.");
        }
        RunInput input = what.apply(run.state());
        return RunViews.view(conducted(() -> operations.wish(kind, run.saved().id(), input)));
    }

    /** It flies on without whoever started it, as its user: bounds of a key cannot be kept. */
    private static void requireWithoutBounds(Principal principal) {
        if (principal.scope().isBounded()) {
            throw Rejection.forbidden("This access key has an area or heights, and a mission run flies without them.");
        }
    }

    private static Target target(RunState run, String id) {
        return run.target(id).orElseThrow(() -> Rejection.unknown("waypoint", id));
    }

    private static DroneId drone(RunState run, String id) {
        return run.drones().stream()
                .map(RunDrone::id)
                .filter(drone -> drone.value().equals(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown("drone", id));
    }

    Picture<RunState> find(Principal principal, String id) {
        return parse(id)
                .flatMap(known -> operations.find(kind, known))
                .filter(run -> isShownTo(principal, run))
                .orElseThrow(() -> Rejection.unknown("mission run", id));
    }

    private static Optional<OperationId> parse(String id) {
        try {
            return Optional.of(new OperationId(id));
        } catch (IllegalArgumentException notAnId) {
            return Optional.empty();
        }
    }

    /** What the conductor refuses is a conflict with what goes on. */
    private static <T> T conducted(Supplier<T> work) {
        try {
            return work.get();
        } catch (Operations.Refused refused) {
            throw Rejection.conflict(refused.why());
        }
    }

    private Instant now() {
        return clock.instant().truncatedTo(ChronoUnit.MICROS);
    }

    private OperationId newId() {
        StringBuilder id = new StringBuilder("r");
        while (id.length() < ID_LENGTH) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new OperationId(id.toString());
    }
}
