package org.dronemap.ws.stream;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.service.DroneViews;
import org.dronemap.ws.service.JsonReader;

/**
 * The newest picture of each drone that changed, written once for all clients of equal rights that want it equally often.
 * {@link #changed} and {@link #removed} from any thread, the rest from the pump alone.
 */
final class DroneFeed {
    private static final long SHORTEST_REST_NANOS = 500_000L;
    private static final long RESTS_IN_A_GAP = 20;
    private static final Pump.Pause NOBODY_LISTENS = new Pump.Pause(5_000_000L, 40_000_000L);

    private final DroneViews views;
    private final JsonReader json;
    private final ConcurrentHashMap<DroneId, DroneState> changed = new ConcurrentHashMap<>();
    // Owned by the pump: by how many pictures a second clients want at most.
    private final Map<Integer, Turns<DroneState>> turns = new HashMap<>();

    /** Those to whom a drone that they may see looks alike. */
    private record Rights(Role role, Set<Permission> permissions) {}

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

    /** No more pictures of this drone. */
    void forget(DroneId id) {
        changed.remove(id);
        turns.values().forEach(each -> each.removed(id));
    }

    /** Hands out what is due, and says when to come again: not too often, so that much news costs no more than some. */
    Pump.Pause publish(Collection<StreamClient> clients, long nowNanos) {
        Map<Integer, List<StreamClient>> groups = new HashMap<>();
        for (StreamClient client : clients) {
            groups.computeIfAbsent(client.perSecond(), rate -> new ArrayList<>())
                    .add(client);
        }
        turns.keySet().retainAll(groups.keySet());
        groups.keySet().forEach(rate -> turns.computeIfAbsent(rate, Turns<DroneState>::new));
        for (Iterator<DroneState> news = changed.values().iterator(); news.hasNext(); ) {
            DroneState state = news.next();
            // A newer state that came in meanwhile stays for the next round.
            if (changed.remove(state.id(), state)) {
                turns.values().forEach(each -> each.changed(state.id(), state));
            }
        }
        if (turns.isEmpty()) {
            return NOBODY_LISTENS;
        }
        long least = Long.MAX_VALUE;
        long most = Long.MAX_VALUE;
        for (Map.Entry<Integer, Turns<DroneState>> entry : turns.entrySet()) {
            Turns<DroneState> each = entry.getValue();
            List<StreamClient> group = groups.getOrDefault(entry.getKey(), List.of());
            each.forget(nowNanos);
            most = Math.min(most, each.take(nowNanos, state -> hand(state, group)));
            least = Math.min(least, each.gapNanos() / RESTS_IN_A_GAP);
        }
        return new Pump.Pause(Math.max(SHORTEST_REST_NANOS, least), Math.max(SHORTEST_REST_NANOS, most));
    }

    private void hand(DroneState state, Collection<StreamClient> clients) {
        Map<Rights, String> written = new HashMap<>();
        for (StreamClient client : clients) {
            Principal principal = client.principal().orElse(null);
            if (principal == null || !client.wants(state.id())) {
                continue;
            }
            Set<Permission> permissions = principal.permissions(state.id());
            if (permissions.isEmpty()) {
                continue;
            }
            String picture = written.computeIfAbsent(
                    new Rights(principal.role(), permissions),
                    unused -> json.write(new StreamMessage.Drone(views.view(state, principal))));
            client.shown().put(state.id(), permissions);
            client.outbox().offer(state.id(), picture);
        }
    }
}
