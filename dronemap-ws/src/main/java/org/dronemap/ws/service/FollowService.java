package org.dronemap.ws.service;

import java.security.SecureRandom;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowOrder;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.conduct.Operations;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.Sighting;

/** Use cases around follows: ask for one, start, tell where the phone is, pause, change, stop. Any thread. */
public final class FollowService {
    private static final String LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";
    private static final int ID_LENGTH = 16;
    private static final int MOST_UNDER_WAY = 50;
    private static final int MOST_LISTED = 50;
    private static final Comparator<Picture<FollowState>> NEWEST_FIRST = Comparator.comparing(
                    (Picture<FollowState> follow) -> follow.saved().beganAt())
            .reversed();

    private final Operations operations;
    private final OperationKind<FollowState, FollowInput> kind;
    private final CloudManager cloud;
    private final FollowDrones drones;
    private final Warehouse warehouse;
    private final Clock clock;
    private final SecureRandom random = new SecureRandom();

    /** What follows are conducted by. */
    public record Conduct(Operations operations, OperationKind<FollowState, FollowInput> kind, CloudManager cloud) {}

    /** The drones that may be armed with nobody beside them, as they are whenever it is asked. */
    @FunctionalInterface
    public interface Warehouse {
        Set<DroneId> drones();
    }

    public FollowService(Conduct conduct, Warehouse warehouse, Clock clock) {
        this.operations = conduct.operations();
        this.kind = conduct.kind();
        this.cloud = conduct.cloud();
        this.drones = new FollowDrones(cloud);
        this.warehouse = warehouse;
        this.clock = clock;
    }

    private static boolean isShownTo(Principal principal, Picture<FollowState> follow) {
        return principal.organisation().equals(follow.saved().organisation())
                && principal.sees(follow.state().drone());
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<FollowView> all(Principal principal) {
        Roles.require(principal, Role.VIEWER);
        List<Picture<FollowState>> follows = new ArrayList<>(operations.underWay(kind));
        operations.latest(principal.organisation(), MOST_LISTED).stream()
                .filter(saved -> saved.endedAt() != null && saved.kind().equals(kind.name()))
                .map(saved -> new Picture<>(saved, kind.codec().state(saved.state())))
                .forEach(follows::add);
        return follows.stream()
                .filter(follow -> isShownTo(principal, follow))
                .sorted(NEWEST_FIRST)
                .map(FollowView::of)
                .toList();
    }

    public FollowView one(Principal principal, String id) {
        Roles.require(principal, Role.VIEWER);
        return FollowView.of(find(principal, id));
    }

    /** A drone is chosen and kept for it; it stays on the ground until it is started. */
    public FollowView open(Principal principal, FollowRequest.OpenRequest request) {
        Roles.require(principal, Role.OPERATOR);
        requireWithoutBounds(principal);
        String name = FollowReader.name(request);
        Geodetic near = FollowReader.near(request);
        FollowOrder.Place place = FollowReader.place(request);
        FollowDrones.Task task = new FollowDrones.Task(near, place, FollowReader.minutes(request));
        double speed = FollowReader.speed(request);
        int patience = FollowReader.patience(request);
        requireRoom(principal);
        FollowOrder.Chosen chosen = drones.choose(principal, candidates(principal, request), task);
        Instant at = now();
        FollowOrder order = new FollowOrder(
                chosen, near, place, speed, drones.fences(principal.name(), chosen.drone(), at), patience);
        OperationId id = newId();
        FollowState state = FollowState.begin(id, order, at);
        giveBack(principal, chosen.drone());
        SavedOperation begun = SavedOperation.begun(
                id, kind.name(), new SavedOperation.Owner(principal.name(), principal.organisation()), name, at);
        return FollowView.of(conducted(() -> operations.begin(kind, begun, state)));
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
                .orElseThrow(() -> Rejection.unknown("drone", wanted)));
    }

    /** What a user has in hand goes over to the follow of the same user. */
    private void giveBack(Principal principal, DroneId drone) {
        if (cloud.controls().control(drone).isHeldBy(principal.name())) {
            cloud.controls().apply(drone, new LeaseEvent.Release(principal.name()));
        }
    }

    private void requireRoom(Principal principal) {
        long underWay = operations.underWay(kind).stream()
                .filter(follow -> follow.saved().organisation().equals(principal.organisation()))
                .count();
        if (underWay >= MOST_UNDER_WAY) {
            throw Rejection.conflict("Your organisation has " + underWay + " follows under way already.");
        }
    }

    public FollowView start(Principal principal, String id) {
        return wish(principal, id, (by, at) -> new FollowInput.Start(at, by));
    }

    public FollowView cancel(Principal principal, String id) {
        return wish(principal, id, (by, at) -> new FollowInput.Cancel(at, by));
    }

    public FollowView pause(Principal principal, String id) {
        return wish(principal, id, (by, at) -> new FollowInput.Pause(at, by));
    }

    /** The only way in which a drone that somebody took comes back to its follow. */
    public FollowView goOn(Principal principal, String id) {
        Roles.require(principal, Role.OPERATOR);
        giveBack(principal, find(principal, id).state().drone());
        return wish(principal, id, (by, at) -> new FollowInput.GoOn(at, by));
    }

    public FollowView stop(Principal principal, String id) {
        return wish(principal, id, (by, at) -> new FollowInput.Stop(at, by));
    }

    public FollowView change(Principal principal, String id, FollowRequest.PlaceRequest request) {
        Roles.require(principal, Role.OPERATOR);
        FollowOrder.Place place =
                FollowReader.place(request, find(principal, id).state().order().place(), "");
        return wish(principal, id, (by, at) -> new FollowInput.Change(at, by, place));
    }

    /** Where the phone is; whoever asked to be followed says that, and nobody else. */
    public FollowView positions(Principal principal, String id, FollowRequest.PositionsRequest request) {
        Roles.require(principal, Role.OPERATOR);
        Picture<FollowState> follow = find(principal, id);
        if (!follow.saved().owner().equals(principal.name())) {
            throw Rejection.forbidden("Only " + follow.saved().owner() + " says where the phone is.");
        }
        if (follow.saved().endedAt() != null) {
            throw Rejection.conflict("This follow is over.");
        }
        for (Sighting sighting : FollowReader.sightings(request, now())) {
            if (!operations.sighted(kind, follow.saved().id(), sighting)) {
                throw new Rejection(
                        RejectionKind.UNAVAILABLE, "The server is overloaded; say only where the phone is now.");
            }
        }
        return FollowView.of(follow);
    }

    private FollowView wish(Principal principal, String id, BiFunction<String, Instant, FollowInput> what) {
        Roles.require(principal, Role.OPERATOR);
        Picture<FollowState> follow = find(principal, id);
        requireWithoutBounds(principal);
        Roles.require(principal, Role.OPERATOR, follow.state().drone());
        if (follow.saved().endedAt() != null) {
            throw Rejection.conflict("This follow is over.");
        }
        FollowInput input = what.apply(principal.name(), now());
        return FollowView.of(
                conducted(() -> operations.wish(kind, follow.saved().id(), input)));
    }

    /** It flies on without whoever started it, as its user: bounds of a key cannot be kept. */
    private static void requireWithoutBounds(Principal principal) {
        if (principal.scope().isBounded()) {
            throw Rejection.forbidden("This access key has an area or heights, and a follow flies without them.");
        }
    }

    private Picture<FollowState> find(Principal principal, String id) {
        return parse(id)
                .flatMap(known -> operations.find(kind, known))
                .filter(follow -> isShownTo(principal, follow))
                .orElseThrow(() -> Rejection.unknown("follow", id));
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
        StringBuilder id = new StringBuilder("f");
        while (id.length() < ID_LENGTH) {
            id.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
        }
        return new OperationId(id.toString());
    }
}
