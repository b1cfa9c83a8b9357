package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.JsonReader;

/**
 * The newest picture of each drone that changed, at most five times a second a drone, written once for all clients of
 * a role. {@link #changed} from any thread, the rest from the pump alone.
 */
final class DroneFeed {
    private static final long SHORTEST_GAP_NANOS = 200_000_000L;

    private final DroneViews views;
    private final JsonReader json;
    private final ConcurrentHashMap<DroneId, DroneState> changed = new ConcurrentHashMap<>();
    // owned by the pump
    private final Map<DroneId, Long> sentNanos = new HashMap<>();

    DroneFeed(DroneViews views, JsonReader json) {
        this.views = views;
        this.json = json;
    }

    void changed(DroneState state) {
        changed.put(state.id(), state);
    }

    void removed(DroneId id) {
        changed.remove(id);
    }

    void publish(Collection<StreamClient> clients, long nowNanos) {
        for (Iterator<Map.Entry<DroneId, DroneState>> entries =
                        changed.entrySet().iterator();
                entries.hasNext(); ) {
            Map.Entry<DroneId, DroneState> entry = entries.next();
            Long last = sentNanos.get(entry.getKey());
            if (last != null && nowNanos - last < SHORTEST_GAP_NANOS) {
                continue;
            }
            // a newer state that came in meanwhile stays for the next round
            if (changed.remove(entry.getKey(), entry.getValue())) {
                sentNanos.put(entry.getKey(), nowNanos);
                hand(entry.getValue(), clients);
            }
        }
        sentNanos.values().removeIf(last -> nowNanos - last > 60_000_000_000L);
    }

    private void hand(DroneState state, Collection<StreamClient> clients) {
        Map<Role, String> written = new EnumMap<>(Role.class);
        for (StreamClient client : clients) {
            Principal principal = client.principal().orElse(null);
            if (principal != null && client.wants(state.id())) {
                client.outbox()
                        .offer(
                                state.id(),
                                written.computeIfAbsent(
                                        principal.role(),
                                        role -> json.write(new StreamMessage.Drone(views.view(state, role)))));
            }
        }
    }
}
