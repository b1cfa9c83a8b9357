package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.conduct.OperationListener;
import org.dronemap.core.conduct.Operations.Picture;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.ws.service.JsonReader;
import org.dronemap.ws.service.RunService;
import org.dronemap.ws.service.RunViews;

/**
 * The newest picture of each mission run for whoever may see it, four times a second at most. What it hears comes from the
 * conductor's thread, the rest belongs to the pump.
 */
final class RunFeed implements OperationListener {
    private static final long GAP_NANOS = 250_000_000L;

    private final RunService runs;
    private final JsonReader json;
    private final Runnable wake;
    private final ConcurrentHashMap<OperationId, SavedOperation> changed = new ConcurrentHashMap<>();
    // Owned by the pump: who has been shown all of them, and when it told last.
    private final Map<StreamClient, Principal> welcomed = new WeakHashMap<>();
    private long toldNanos = System.nanoTime() - GAP_NANOS;

    /** {@code wake} asks for a round of the pump. */
    RunFeed(RunService runs, JsonReader json, Runnable wake) {
        this.runs = runs;
        this.json = json;
        this.wake = wake;
    }

    @Override
    public void changed(SavedOperation operation, String why) {
        changed.put(operation.id(), operation);
        wake.run();
    }

    /** Hands out what is due. */
    void publish(Collection<StreamClient> clients, long nowNanos) {
        for (StreamClient client : clients) {
            client.principal().ifPresent(principal -> welcome(client, principal));
        }
        if (changed.isEmpty() || nowNanos - toldNanos < GAP_NANOS) {
            return;
        }
        toldNanos = nowNanos;
        for (OperationId id : Set.copyOf(changed.keySet())) {
            Optional.ofNullable(changed.remove(id))
                    .flatMap(runs::picture)
                    .ifPresent(run -> clients.forEach(
                            client -> client.principal().ifPresent(principal -> show(client, principal, run))));
        }
    }

    /** Those under way; what is over is asked for. */
    private void welcome(StreamClient client, Principal principal) {
        if (!Objects.equals(welcomed.put(client, principal), principal)) {
            runs.underWay().forEach(run -> show(client, principal, run));
        }
    }

    private void show(StreamClient client, Principal principal, Picture<RunState> run) {
        if (RunService.isShownTo(principal, run)) {
            client.outbox().offer(line(run.saved().id()), json.write(new StreamMessage.RunChanged(RunViews.view(run))));
        }
    }

    /** Its pictures wait among those of drones, the newest one only; no id of a drone begins like this. */
    private static DroneId line(OperationId id) {
        return new DroneId("r-" + id.value());
    }
}
