package org.dronemap.ws.plan;

import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.random.RandomGenerator;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.engine.PlanResult;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.conduct.TakeOffClearance;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.OperationProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Lets users request, watch, cancel and accept plans for several drones. Each belongs to who asked for it. Any thread.
 */
public final class PlanService {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int ID_LENGTH = 16;
    private static final String CLOUD_LOSS = "continue or rtl";
    /** A drone that was moved farther no longer stands where its tour begins. */
    private static final double MOST_MOVED_METERS = 15;

    private static final Duration LONGEST_AT_START = Duration.ofSeconds(2);

    /** The separation of drones that fly plans: the least distance in them, and the clearance before they rise. */
    public record SeparationContext(Separation least, TakeOffClearance clearance) {}

    private final PlanJobExecutor desk;
    private final PoolPlanDrones pool;
    private final PlanReader reader;
    private final DroneService drones;
    private final CommandService commands;
    private final TakeOffClearance clearance;
    private final Clock clock;
    private final RandomGenerator random;

    public PlanService(
            PlanJobExecutor desk,
            DroneService drones,
            CommandService commands,
            PoolPlanDrones pool,
            ZoneRegistry zones,
            SeparationContext apart,
            Time time) {
        this.desk = desk;
        this.pool = pool;
        this.reader = new PlanReader(drones, pool, zones, apart.least(), time.clock());
        this.drones = drones;
        this.commands = commands;
        this.clearance = apart.clearance();
        this.clock = time.clock();
        this.random = time.random();
    }

    /** Others do not exist for this one. */
    public static boolean isShownTo(Principal principal, PlanJob job) {
        return job.account().equals(principal.account())
                && job.organisation().equals(principal.organisation())
                && job.order().drones().stream().allMatch(drone -> principal.sees(drone.id()));
    }

    public PlanView ask(Principal principal, PlanRequest request) {
        RoleChecks.require(principal, Role.PLANNER);
        PlanJobInput order = reader.read(principal, request);
        PlanJob job = new PlanJob(
                newId(),
                new PlanJob.Origin(principal.name(), principal.account(), principal.organisation(), clock.instant()),
                order);
        desk.submit(job);
        return PlanViewMapper.whole(job);
    }

    /** One's own, the oldest first. */
    public List<PlanView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return desk.jobs(principal.organisation()).stream()
                .filter(job -> isShownTo(principal, job))
                .map(PlanViewMapper::brief)
                .toList();
    }

    public PlanView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return PlanViewMapper.whole(find(principal, id));
    }

    /** Cancels one that is under way; forgets one that has ended. */
    public void remove(Principal principal, String id) {
        RoleChecks.require(principal, Role.PLANNER);
        PlanJob job = find(principal, id);
        if (job.status().busy()) {
            throw Rejection.of(
                    OperationProblem.PLAN_UNDER_WAY,
                    "Its missions are on their way to the drones, or drones wait for their start: stop it first.");
        }
        desk.remove(job);
    }

    /** Uploads each drone's mission, and starts the drones if that is asked for; ended, or as it stands after that wait. */
    public CompletableFuture<PlanView> accept(
            Caller caller, String id, PlanRequest.@Nullable AcceptRequest request, Duration wait) {
        Principal principal = caller.principal();
        RoleChecks.require(principal, Role.PLANNER);
        PlanLauncher.Start start = start(request);
        if (start.wanted()) {
            RoleChecks.require(principal, Role.OPERATOR);
        }
        PlanJob job = find(principal, id);
        List<Tour> tours = acceptable(principal, job, start.wanted());
        PlanResult planned = job.status().result();
        if (start.wanted() && planned != null) {
            job.order().requireWaysHome(planned.plan());
        }
        boolean begun = job.accept(tours.stream()
                .map(tour -> new DroneLaunchStatus(tour.drone(), DroneLaunchStatus.Stage.UPLOADING, null, null))
                .toList());
        if (!begun) {
            throw Rejection.of(OperationProblem.PLAN_UNDER_WAY, "Its missions are on their way to the drones already.");
        }
        CompletableFuture<Void> run = new PlanLauncher(desk, commands, clearance, job, caller, start).run(tours);
        return desk.time()
                .within(run.<Optional<Void>>thenApply(ended -> Optional.empty()), wait, Optional.empty())
                .thenApply(ended -> PlanViewMapper.whole(job));
    }

    /** A plan that may be flown now, with what it was made for. */
    public record Flyable(PlanJobInput order, PlanResult planned) {}

    /** For who flies it from now on; refused as if it were started. */
    public Flyable flyable(Principal principal, String id) {
        PlanJob job = find(principal, id);
        PlanRequest ofPool = job.order().ofPool();
        if (ofPool != null && !isFlyableNow(principal, job)) {
            return replanned(principal, ofPool);
        }
        acceptable(principal, job, true);
        PlanResult planned = job.status().result();
        if (planned == null || job.status().busy()) {
            throw Rejection.of(OperationProblem.PLAN_UNDER_WAY, "Its missions are on their way to the drones already.");
        }
        job.order().requireWaysHome(planned.plan());
        return new Flyable(job.order(), planned);
    }

    /** All drones that it needs are free still, and where they were. */
    private boolean isFlyableNow(Principal principal, PlanJob job) {
        try {
            return acceptable(principal, job, true).stream().allMatch(tour -> pool.isFree(tour.drone()));
        } catch (Rejection changed) {
            if (changed.code() == OperationProblem.PLAN_NOT_FINISHED
                    || changed.code() == OperationProblem.PLAN_WITHOUT_RESULT) {
                throw changed;
            }
            return false;
        }
    }

    /** Others of the pool stand in for those that are not free any more; a short search, since somebody waits. */
    private Flyable replanned(Principal principal, PlanRequest request) {
        PlanJobInput order = reader.read(principal, request);
        Duration search = order.search().compareTo(LONGEST_AT_START) < 0 ? order.search() : LONGEST_AT_START;
        PlanResult planned = FleetPlanner.plan(
                order.problem(),
                order.seed(),
                SearchBudget.time(search, desk.time().effort()),
                better -> {});
        List<String> faults = order.faults(planned);
        if (!faults.isEmpty() || planned.plan().tours().isEmpty()) {
            throw Rejection.of(
                    OperationProblem.PLAN_OUTDATED_POOL,
                    "Not all drones of the plan are free any more, and others of the pool cannot fly it. "
                            + String.join(" ", faults));
        }
        order.requireWaysHome(planned.plan());
        return new Flyable(order, planned);
    }

    /** Whoever of the plan has not been started yet will not be; who flies, flies on. */
    public PlanView stop(Principal principal, String id) {
        RoleChecks.require(principal, Role.OPERATOR);
        PlanJob job = find(principal, id);
        if (!job.stop(DroneLaunchStatus.Reason.of(
                OperationProblem.PLAN_STOPPED,
                "It has its mission and was not started, since the start was stopped."))) {
            throw Rejection.of(OperationProblem.PLAN_STARTS_NOBODY, "Nobody of this plan waits for a start.");
        }
        return PlanViewMapper.whole(job);
    }

    private static PlanLauncher.Start start(PlanRequest.@Nullable AcceptRequest request) {
        String onCloudLoss = request == null ? null : request.onCloudLoss();
        if (onCloudLoss != null && !onCloudLoss.equals("continue") && !onCloudLoss.equals("rtl")) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_NOT_ALLOWED, "onCloudLoss", CLOUD_LOSS, "\"" + onCloudLoss + "\"");
        }
        return new PlanLauncher.Start(request != null && Boolean.TRUE.equals(request.start()), onCloudLoss);
    }

    /** Its tours, when nothing speaks against flying it. */
    private List<Tour> acceptable(Principal principal, PlanJob job, boolean start) {
        PlanJob.Status status = job.status();
        PlanResult planned = status.result();
        if (planned == null) {
            throw Rejection.of(
                    status.state().isUnderWay()
                            ? OperationProblem.PLAN_NOT_FINISHED
                            : OperationProblem.PLAN_WITHOUT_RESULT,
                    "The plan is not finished.");
        }
        List<String> faults = job.order().faults(planned);
        if (!faults.isEmpty()) {
            throw Rejection.of(OperationProblem.PLAN_UNSAFE, "The plan must not be flown: " + String.join(" ", faults));
        }
        if (planned.plan().tours().isEmpty()) {
            throw Rejection.of(OperationProblem.PLAN_EMPTY, "Nobody flies in this plan.");
        }
        for (Tour tour : planned.plan().tours()) {
            String id = tour.drone().value();
            DroneState now = start
                    ? drones.state(principal, id, Role.OPERATOR)
                    : drones.state(principal, id, Role.OPERATOR, Role.PLANNER);
            requireUnmoved(job, now);
        }
        return planned.plan().tours();
    }

    /** Its tour begins where it stood when the plan was asked for, and ends at the home that it had. */
    private static void requireUnmoved(PlanJob job, DroneState now) {
        if (now.airborne()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_AIRBORNE),
                    "“" + now.name() + "” is in the air; plan again when it is on the ground.",
                    ProblemParameter.DRONE.is(now.id().value()));
        }
        Home home = now.home();
        boolean unmoved = home != null
                && job.order().problem().crafts().stream()
                        .filter(craft -> craft.id().equals(now.id()))
                        .allMatch(craft -> Geodesy.distanceMeters(
                                                craft.start().place().point(),
                                                PlanDroneFactory.stand(now, home)
                                                        .point())
                                        <= MOST_MOVED_METERS
                                && Geodesy.distanceMeters(craft.finish().place().point(), home.point())
                                        <= MOST_MOVED_METERS);
        if (!unmoved) {
            throw Rejection.of(
                    OperationProblem.PLAN_OUTDATED,
                    "“" + now.name() + "”, or its home, is no longer where it was when this was planned; plan again.",
                    ProblemParameter.DRONE.is(now.id().value()));
        }
    }

    private PlanJob find(Principal principal, String id) {
        return desk.find(id)
                .filter(job -> isShownTo(principal, job))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.PLAN, id));
    }

    /** Not to be guessed, and fit to stand beside ids of drones. */
    private String newId() {
        StringBuilder id = new StringBuilder();
        while (id.length() < ID_LENGTH) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return id.toString();
    }
}
