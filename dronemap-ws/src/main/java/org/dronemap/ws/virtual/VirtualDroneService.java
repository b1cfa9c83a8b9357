package org.dronemap.ws.virtual;

import java.time.Clock;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.time.Time;
import org.dronemap.core.virtual.DroneRequirements;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.core.virtual.VirtualPlan;
import org.dronemap.core.virtual.VirtualTour;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.mission.MissionReader;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ObjectionProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.virtual.VirtualDroneViewMapper.VirtualAction;
import org.jspecify.annotations.Nullable;

/**
 * Lets users create, change, start and stop virtual drones, which real drones of the warehouse serve. Each belongs to
 * who made it; supervisors see all. Any thread.
 */
public final class VirtualDroneService {
    static final int LONGEST_NAME = 60;
    private static final int MOST_OF_ONE_USER = 50;
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int ID_LENGTH = 12;
    private static final String CLOUD_LOSS = "continue or rtl";

    private final VirtualDrones virtuals;
    private final VirtualDroneViewMapper views;
    private final Clock clock;
    private final RandomGenerator random;

    public VirtualDroneService(VirtualDrones virtuals, VirtualDroneViewMapper views, Time time) {
        this.virtuals = virtuals;
        this.views = views;
        this.clock = time.clock();
        this.random = time.random();
    }

    /** Others do not exist for this one. */
    public static boolean isShownTo(Principal principal, VirtualDrone drone) {
        return principal.organisation().equals(drone.organisation())
                && principal.mayVirtually(Role.VIEWER)
                && (drone.account().equals(principal.account())
                        || (principal.may(Role.SUPERVISOR) && principal.isWhole()));
    }

    public List<VirtualDroneView> all(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return virtuals.all().stream()
                .filter(drone -> isShownTo(principal, drone))
                .map(drone -> views.view(drone, principal))
                .toList();
    }

    public VirtualDroneView one(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        return views.view(find(principal, id), principal);
    }

    public VirtualDroneView add(Principal principal, VirtualDroneRequest request) {
        requireVirtually(principal, Role.PLANNER);
        long own = virtuals.all().stream()
                .filter(drone -> drone.account().equals(principal.account()))
                .count();
        if (own >= MOST_OF_ONE_USER) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "You have " + MOST_OF_ONE_USER + " virtual drones already; remove one first.",
                    ProblemParameter.WHAT.is("virtual drones"),
                    ProblemParameter.MOST.is(MOST_OF_ONE_USER));
        }
        VirtualDrone drone = new VirtualDrone(
                newId(),
                name(request),
                principal.name(),
                principal.account(),
                principal.organisation(),
                plan(request),
                List.of(),
                List.of(),
                clock.instant().truncatedTo(ChronoUnit.MICROS));
        conducted(drone.id(), () -> {
            virtuals.add(drone);
            return drone;
        });
        return views.view(drone, principal);
    }

    /** Holds from the next start on; what is under way goes on as it was asked for. */
    public VirtualDroneView replace(Principal principal, String id, VirtualDroneRequest request) {
        VirtualDroneId known = allowed(principal, id, VirtualAction.PLAN);
        String name = name(request);
        VirtualPlan plan = plan(request);
        return views.view(conducted(known, () -> virtuals.edit(known, now -> now.with(name, plan))), principal);
    }

    public VirtualDroneView start(Principal principal, String id, VirtualDroneRequest.@Nullable StartRequest request) {
        MissionCloudLossPolicy onCloudLoss = onCloudLoss(request == null ? null : request.onCloudLoss());
        VirtualDroneId known = allowed(principal, id, VirtualAction.START);
        return views.view(conducted(known, () -> virtuals.launch(known, onCloudLoss)), principal);
    }

    public VirtualDroneView stop(Principal principal, String id) {
        VirtualDroneId known = allowed(principal, id, VirtualAction.STOP);
        return views.view(conducted(known, () -> virtuals.stop(known)), principal);
    }

    public VirtualDroneView resume(Principal principal, String id) {
        VirtualDroneId known = allowed(principal, id, VirtualAction.RESUME);
        return views.view(conducted(known, () -> virtuals.resume(known)), principal);
    }

    public void remove(Principal principal, String id) {
        VirtualDroneId known = allowed(principal, id, VirtualAction.REMOVE);
        conducted(known, () -> {
            virtuals.remove(known);
            return known;
        });
    }

    private VirtualDroneId allowed(Principal principal, String id, VirtualAction action) {
        requireVirtually(principal, action.needed());
        VirtualDrone drone = find(principal, id);
        action.whyNot(drone, principal).ifPresent(why -> {
            throw why;
        });
        return drone.id();
    }

    private static void requireVirtually(Principal principal, Role needed) {
        RoleChecks.require(principal, needed);
        if (!principal.mayVirtually(needed)) {
            throw notVirtually(principal);
        }
    }

    private static Rejection notVirtually(Principal principal) {
        if (!principal.scope().coversAllDrones()) {
            return Rejection.of(
                    AccessProblem.KEY_FOR_SOME_DRONES,
                    "This access key is for certain drones only, and any may serve a virtual one.");
        }
        return principal.scope().isBounded()
                ? Rejection.of(
                        AccessProblem.KEY_BOUNDED,
                        "This access key has an area or heights, and a virtual drone flies without it.")
                : Rejection.of(
                        AccessProblem.NOT_GRANTED,
                        "This was not granted to you with virtual drones; ask an administrator.");
    }

    private VirtualDrone find(Principal principal, String id) {
        return parse(id)
                .flatMap(virtuals::find)
                .filter(drone -> isShownTo(principal, drone))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.VIRTUAL_DRONE, id));
    }

    private static Optional<VirtualDroneId> parse(String id) {
        try {
            return Optional.of(new VirtualDroneId(id));
        } catch (IllegalArgumentException notAnId) {
            return Optional.empty();
        }
    }

    private static String name(VirtualDroneRequest request) {
        return NameRules.checked("name", request.name(), LONGEST_NAME);
    }

    private static VirtualPlan plan(VirtualDroneRequest request) {
        DroneRequirements needs = DroneRequirementsReader.read(request.needs());
        Integer upTo = request.upTo();
        return new VirtualPlan(
                needs,
                mission(request.items()),
                upTo == null ? 1 : FieldRanges.checked("upTo", upTo, 1, VirtualPlan.MOST_DRONES, " drones"));
    }

    private static @Nullable Mission mission(@Nullable List<MissionItemRequest> items) {
        if (items == null || items.isEmpty()) {
            return null;
        }
        Mission mission = MissionReader.read(items);
        VirtualTour.fault(mission).ifPresent(fault -> {
            throw new InvalidInput(
                    ValueProblem.MISSION_UNUSABLE,
                    "items",
                    "a take-off, waypoints, then returnToLaunch or land",
                    fault);
        });
        return mission;
    }

    private static MissionCloudLossPolicy onCloudLoss(@Nullable String name) {
        return switch (name == null ? "continue" : name) {
            case "continue" -> MissionCloudLossPolicy.CONTINUE;
            case "rtl" -> MissionCloudLossPolicy.RETURN_TO_LAUNCH;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, "onCloudLoss", CLOUD_LOSS, "\"" + name + "\"");
        };
    }

    /** What the conductor refuses is a conflict with what goes on. */
    private static <T> T conducted(VirtualDroneId id, Supplier<T> work) {
        try {
            return work.get();
        } catch (VirtualDrones.Refused refused) {
            throw ObjectionProblem.rejection(refused.objection(), id.value());
        }
    }

    private VirtualDroneId newId() {
        StringBuilder id = new StringBuilder("v");
        while (id.length() < ID_LENGTH) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new VirtualDroneId(id.toString());
    }
}
