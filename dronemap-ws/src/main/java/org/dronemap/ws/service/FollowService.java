package org.dronemap.ws.service;

import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
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
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.Sighting;

/** Use cases around follows: ask for one, start, tell where the phone is, pause, change, stop. Any thread. */
public final class FollowService {
    private final Operations operations;
    private final OperationKind<FollowState, FollowInput> kind;
    private final OperationDesk<FollowState, FollowInput> desk;
    private final FollowDrones drones;
    private final Warehouse warehouse;

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
        this.drones = new FollowDrones(conduct.cloud());
        this.warehouse = warehouse;
        desk = new OperationDesk<>(
                operations,
                kind,
                conduct.cloud(),
                new OperationDesk.Words('f', "follow", "a follow flies"),
                (principal, follow) -> principal.sees(follow.state().drone()),
                clock);
    }

    /** Those under way and the newest that are over, the newest first. */
    public List<FollowView> all(Principal principal) {
        Roles.require(principal, Role.VIEWER);
        return desk.all(principal).stream().map(FollowView::of).toList();
    }

    public FollowView one(Principal principal, String id) {
        Roles.require(principal, Role.VIEWER);
        return FollowView.of(desk.find(principal, id));
    }

    /** A drone is chosen and kept for it; it stays on the ground until it is started. */
    public FollowView open(Principal principal, FollowRequest.OpenRequest request) {
        Roles.require(principal, Role.OPERATOR);
        desk.requireWithoutBounds(principal);
        String name = FollowReader.name(request);
        Geodetic near = FollowReader.near(request);
        FollowOrder.Place place = FollowReader.place(request);
        FollowDrones.Task task = new FollowDrones.Task(near, place, FollowReader.minutes(request));
        double speed = FollowReader.speed(request);
        int patience = FollowReader.patience(request);
        desk.requireRoom(principal);
        FollowOrder.Chosen chosen = drones.choose(principal, candidates(principal, request), task);
        Instant at = desk.now();
        FollowOrder order = new FollowOrder(
                chosen, near, place, speed, drones.fences(principal.name(), chosen.drone(), at), patience);
        OperationId id = desk.newId();
        FollowState state = FollowState.begin(id, order, at);
        return FollowView.of(desk.begin(principal, id, name, state, at));
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
        return wish(principal, id, (by, at) -> new FollowInput.GoOn(at, by), true);
    }

    public FollowView stop(Principal principal, String id) {
        return wish(principal, id, (by, at) -> new FollowInput.Stop(at, by));
    }

    public FollowView change(Principal principal, String id, FollowRequest.PlaceRequest request) {
        Roles.require(principal, Role.OPERATOR);
        FollowOrder.Place place = FollowReader.place(
                request, desk.find(principal, id).state().order().place(), "");
        return wish(principal, id, (by, at) -> new FollowInput.Change(at, by, place));
    }

    /** Where the phone is; whoever asked to be followed says that, and nobody else. */
    public FollowView positions(Principal principal, String id, FollowRequest.PositionsRequest request) {
        Roles.require(principal, Role.OPERATOR);
        Picture<FollowState> follow = desk.find(principal, id);
        if (!follow.saved().owner().equals(principal.name())) {
            throw Rejection.forbidden("Only " + follow.saved().owner() + " says where the phone is.");
        }
        if (follow.saved().endedAt() != null) {
            throw Rejection.conflict("This follow is over.");
        }
        for (Sighting sighting : FollowReader.sightings(request, desk.now())) {
            if (!operations.sighted(kind, follow.saved().id(), sighting)) {
                throw new Rejection(
                        RejectionKind.UNAVAILABLE, "The server is overloaded; say only where the phone is now.");
            }
        }
        return FollowView.of(follow);
    }

    private FollowView wish(Principal principal, String id, BiFunction<String, Instant, FollowInput> what) {
        return wish(principal, id, what, false);
    }

    /** {@code hands}: control that the user has of the drone goes over to the follow, once nothing speaks against the wish. */
    private FollowView wish(
            Principal principal, String id, BiFunction<String, Instant, FollowInput> what, boolean hands) {
        Roles.require(principal, Role.OPERATOR);
        Picture<FollowState> follow = desk.find(principal, id);
        desk.requireWithoutBounds(principal);
        Roles.require(principal, Role.OPERATOR, follow.state().drone());
        if (follow.saved().endedAt() != null) {
            throw Rejection.conflict("This follow is over.");
        }
        if (hands) {
            desk.giveBack(principal, follow.state().drone());
        }
        return FollowView.of(desk.wish(follow, what.apply(principal.name(), desk.now())));
    }
}
