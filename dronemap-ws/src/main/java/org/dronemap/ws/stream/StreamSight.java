package org.dronemap.ws.stream;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.access.GrantBook;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.service.JsonReader;

/**
 * Takes from clients the drones that they may see no longer, and shows them what they have come to see: when grants were
 * changed, have begun or have ended. Owned by the pump.
 */
final class StreamSight {
    private final CloudManager cloud;
    private final GrantBook grants;
    private final DroneFeed feed;
    private final JsonReader json;
    private long edition;

    StreamSight(CloudManager cloud, GrantBook grants, DroneFeed feed, JsonReader json) {
        this.cloud = cloud;
        this.grants = grants;
        this.feed = feed;
        this.json = json;
    }

    void settle(Collection<StreamClient> clients) {
        long now = grants.edition();
        boolean changed = now != edition;
        edition = now;
        Set<DroneId> news = new HashSet<>();
        List<DroneState> drones = null;
        for (StreamClient client : clients) {
            if (!client.settle() && !changed) {
                continue;
            }
            if (drones == null) {
                drones = cloud.drones();
            }
            settle(client, drones, news);
        }
        if (drones != null) {
            drones.stream().filter(drone -> news.contains(drone.id())).forEach(feed::changed);
        }
    }

    private void settle(StreamClient client, List<DroneState> drones, Set<DroneId> news) {
        Principal principal = client.principal().orElse(null);
        if (principal == null) {
            return;
        }
        for (DroneId shown : client.shown().keySet()) {
            if (!principal.sees(shown)) {
                client.shown().remove(shown);
                client.outbox().withhold(shown);
                client.outbox().add(json.write(new StreamMessage.DroneRemoved(shown.value())));
            }
        }
        for (DroneState drone : drones) {
            Set<Permission> permissions = principal.permissions(drone.id());
            if (!permissions.isEmpty() && !permissions.equals(client.shown().get(drone.id()))) {
                news.add(drone.id());
            }
        }
    }
}
