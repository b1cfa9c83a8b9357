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
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.PlanDesk;
import org.dronemap.ws.service.PlanJob;
import org.dronemap.ws.service.PlanListener;
import org.dronemap.ws.service.PlanService;
import org.dronemap.ws.service.PlanViews;

/**
 * The newest picture of each plan for who asked for it, four times a second at most: while a search finds better plans,
 * there are thousands. What it hears comes from any thread, the rest belongs to the pump.
 */
final class PlanFeed implements PlanListener {
    private static final long GAP_NANOS = 250_000_000L;

    private final PlanDesk desk;
    private final JsonReader json;
    private final Runnable wake;
    private final Set<String> changed = ConcurrentHashMap.newKeySet();
    private final Queue<PlanJob> removed = new ConcurrentLinkedQueue<>();
    // Owned by the pump: who has been shown all of them, and when it told last.
    private final Map<StreamClient, Principal> welcomed = new WeakHashMap<>();
    private long toldNanos = System.nanoTime() - GAP_NANOS;

    /** {@code wake} asks for a round of the pump. */
    PlanFeed(PlanDesk desk, JsonReader json, Runnable wake) {
        this.desk = desk;
        this.json = json;
        this.wake = wake;
    }

    @Override
    public void changed(PlanJob job) {
        changed.add(job.id());
        wake.run();
    }

    @Override
    public void removed(PlanJob job) {
        removed.add(job);
        wake.run();
    }

    /** Hands out what is due. */
    void publish(Collection<StreamClient> clients, long nowNanos) {
        for (PlanJob job = removed.poll(); job != null; job = removed.poll()) {
            tellRemoved(clients, job);
        }
        for (StreamClient client : clients) {
            client.principal().ifPresent(principal -> welcome(client, principal));
        }
        if (changed.isEmpty() || nowNanos - toldNanos < GAP_NANOS) {
            return;
        }
        toldNanos = nowNanos;
        for (Iterator<String> ids = changed.iterator(); ids.hasNext(); ) {
            String id = ids.next();
            ids.remove();
            desk.find(id)
                    .ifPresent(job -> clients.forEach(
                            client -> client.principal().ifPresent(principal -> show(client, principal, job))));
        }
    }

    private void welcome(StreamClient client, Principal principal) {
        if (!Objects.equals(welcomed.put(client, principal), principal)) {
            desk.everybodys().forEach(job -> show(client, principal, job));
        }
    }

    private void show(StreamClient client, Principal principal, PlanJob job) {
        if (PlanService.isShownTo(principal, job)) {
            client.outbox().offer(line(job), json.write(new StreamMessage.PlanChanged(PlanViews.whole(job))));
        }
    }

    private void tellRemoved(Collection<StreamClient> clients, PlanJob job) {
        changed.remove(job.id());
        for (StreamClient client : clients) {
            client.outbox().forget(line(job));
            if (client.principal()
                    .filter(principal -> PlanService.isShownTo(principal, job))
                    .isPresent()) {
                client.outbox().add(json.write(new StreamMessage.PlanRemoved(job.id())));
            }
        }
    }

    /** Its pictures wait among those of drones, the newest one only; no id of a drone begins like this. */
    private static DroneId line(PlanJob job) {
        return new DroneId("p-" + job.id());
    }
}
