package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.ws.service.FollowService;
import org.dronemap.ws.service.JsonReader;

/**
 * The newest picture of each follow for whoever may see it: when it changes, and as its drone moves, four times a second at
 * most. What it hears comes from the conductor's thread and from lanes, the rest belongs to the pump.
 */
final class FollowFeed implements OperationListener {
    private static final long GAP_NANOS = 250_000_000L;

    private final FollowService follows;
    private final JsonReader json;
    private final Runnable wake;
    private final ConcurrentHashMap<OperationId, SavedOperation> changed = new ConcurrentHashMap<>();
    private final Set<DroneId> moved = ConcurrentHashMap.newKeySet();
    // Owned by the pump: who has been shown all of them, and when it told last.
    private final Map<StreamClient, Principal> welcomed = new WeakHashMap<>();
    private long toldNanos = System.nanoTime() - GAP_NANOS;

    /** {@code wake} asks for a round of the pump. */
    FollowFeed(FollowService follows, JsonReader json, Runnable wake) {
        this.follows = follows;
        this.json = json;
        this.wake = wake;
    }

    @Override
    public void changed(SavedOperation operation, String why) {
        changed.put(operation.id(), operation);
        wake.run();
    }

    void moved(DroneState state) {
        moved.add(state.id());
    }

    /** Hands out what is due. */
    void publish(Collection<StreamClient> clients, long nowNanos) {
        for (StreamClient client : clients) {
            client.principal().ifPresent(principal -> welcome(client, principal));
        }
        if (nowNanos - toldNanos < GAP_NANOS || (changed.isEmpty() && moved.isEmpty())) {
            return;
        }
        toldNanos = nowNanos;
        List<SavedOperation> news = Set.copyOf(changed.keySet()).stream()
                .map(changed::remove)
                .filter(Objects::nonNull)
                .toList();
        Set<DroneId> drones = Set.copyOf(moved);
        moved.removeAll(drones);
        for (SavedOperation saved : news) {
            follows.picture(saved).ifPresent(follow -> tell(clients, follow));
        }
        for (Picture<FollowState> follow : follows.underWay()) {
            if (drones.contains(follow.state().drone())) {
                tellNow(clients, follow);
            }
        }
    }

    private void tellNow(Collection<StreamClient> clients, Picture<FollowState> follow) {
        OperationId id = follow.saved().id();
        String message = json.write(
                new StreamMessage.FollowNow(id.value(), follows.view(follow).now()));
        for (StreamClient client : clients) {
            if (isShownTo(client, follow)) {
                client.outbox().offer(line("fn-", id), message);
            }
        }
    }

    private static boolean isShownTo(StreamClient client, Picture<FollowState> follow) {
        return client.principal()
                .filter(principal -> FollowService.isShownTo(principal, follow))
                .isPresent();
    }

    /** Those under way; what is over is asked for. */
    private void welcome(StreamClient client, Principal principal) {
        if (!Objects.equals(welcomed.put(client, principal), principal)) {
            follows.underWay().forEach(follow -> tell(List.of(client), follow));
        }
    }

    private void tell(Collection<StreamClient> clients, Picture<FollowState> follow) {
        String message = json.write(new StreamMessage.FollowChanged(follows.view(follow)));
        for (StreamClient client : clients) {
            if (isShownTo(client, follow)) {
                client.outbox().offer(line("f-", follow.saved().id()), message);
            }
        }
    }

    /** Its pictures wait among those of drones, the newest one only; no id of a drone begins like this. */
    private static DroneId line(String kind, OperationId id) {
        return new DroneId(kind + id.value());
    }
}
