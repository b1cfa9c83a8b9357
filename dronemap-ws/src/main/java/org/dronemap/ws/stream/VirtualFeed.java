package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.Iterator;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dronemap.core.access.Principal;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.conduct.VirtualListener;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualDroneId;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.VirtualDroneService;
import org.dronemap.ws.service.VirtualDroneViews;

/**
 * The newest picture of each virtual drone for whoever may see it: at once when its mission goes on, twice a second while a
 * drone serves it. What it hears comes from any thread, the rest belongs to the pump.
 */
final class VirtualFeed implements VirtualListener {
    private static final long LIVE_NANOS = 500_000_000L;

    private final VirtualDrones virtuals;
    private final VirtualDroneViews views;
    private final JsonReader json;
    private final Runnable wake;
    private final Set<VirtualDroneId> changed = ConcurrentHashMap.newKeySet();
    private final Set<DroneId> moved = ConcurrentHashMap.newKeySet();
    private final Queue<VirtualDrone> removed = new ConcurrentLinkedQueue<>();
    // Owned by the pump: who has been shown all of them.
    private final Map<StreamClient, Principal> welcomed = new WeakHashMap<>();
    private long livedNanos = System.nanoTime();

    /** {@code wake} asks for a round of the pump. */
    VirtualFeed(StreamFace.Pictures pictures, JsonReader json, Runnable wake) {
        this.virtuals = pictures.virtuals();
        this.views = pictures.virtualViews();
        this.json = json;
        this.wake = wake;
    }

    @Override
    public void changed(VirtualDrone drone) {
        changed.add(drone.id());
        if (drone.isWaiting() || !drone.isUnderWay()) {
            // Those behind it in the queue may have moved up.
            virtuals.all().stream().filter(VirtualDrone::isWaiting).forEach(waiting -> changed.add(waiting.id()));
        }
        wake.run();
    }

    @Override
    public void removed(VirtualDrone drone) {
        removed.add(drone);
        wake.run();
    }

    void moved(DroneState state) {
        moved.add(state.id());
    }

    /** Hands out what is due. */
    void publish(Collection<StreamClient> clients, long nowNanos) {
        for (VirtualDrone drone = removed.poll(); drone != null; drone = removed.poll()) {
            tellRemoved(clients, drone);
        }
        if (nowNanos - livedNanos >= LIVE_NANOS) {
            livedNanos = nowNanos;
            addMoved();
        }
        for (StreamClient client : clients) {
            client.principal().ifPresent(principal -> welcome(client, principal));
        }
        for (Iterator<VirtualDroneId> ids = changed.iterator(); ids.hasNext(); ) {
            VirtualDroneId id = ids.next();
            ids.remove();
            virtuals.find(id).ifPresent(drone -> tell(clients, drone));
        }
    }

    private void addMoved() {
        if (moved.isEmpty()) {
            return;
        }
        Set<DroneId> now = Set.copyOf(moved);
        moved.removeAll(now);
        virtuals.all().stream()
                .filter(drone -> drone.boundTo() != null && now.contains(drone.boundTo()))
                .forEach(drone -> changed.add(drone.id()));
    }

    private void welcome(StreamClient client, Principal principal) {
        if (!Objects.equals(welcomed.put(client, principal), principal)) {
            virtuals.all().forEach(drone -> show(client, principal, drone));
        }
    }

    private void tell(Collection<StreamClient> clients, VirtualDrone drone) {
        for (StreamClient client : clients) {
            client.principal().ifPresent(principal -> show(client, principal, drone));
        }
    }

    private void show(StreamClient client, Principal principal, VirtualDrone drone) {
        if (VirtualDroneService.isShownTo(principal, drone)) {
            client.outbox()
                    .offer(
                            line(drone),
                            json.write(new StreamMessage.VirtualDroneChanged(views.view(drone, principal))));
        }
    }

    private void tellRemoved(Collection<StreamClient> clients, VirtualDrone drone) {
        changed.remove(drone.id());
        for (StreamClient client : clients) {
            client.outbox().forget(line(drone));
            if (client.principal()
                    .filter(principal -> VirtualDroneService.isShownTo(principal, drone))
                    .isPresent()) {
                client.outbox()
                        .add(json.write(
                                new StreamMessage.VirtualDroneRemoved(drone.id().value())));
            }
        }
    }

    /** Its pictures wait among those of drones, the newest one only; no id of a drone begins like this. */
    private static DroneId line(VirtualDrone drone) {
        return new DroneId("v-" + drone.id().value());
    }
}
