package org.dronemap.ws.house;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.LinkKey;
import org.dronemap.ws.service.OutletControl;
import org.dronemap.ws.service.OutletView;

/** An outlet that only remembers what it was told; as many clients are attached as anybody disconnects. */
final class ListedClients implements OutletControl {
    private final Map<String, LinkKey> keys = new ConcurrentHashMap<>();

    @Override
    public List<String> endpoints() {
        return List.of("udpserver://127.0.0.1:14560");
    }

    @Override
    public boolean hasKey(String user) {
        return keys.containsKey(user);
    }

    @Override
    public boolean putKey(String user, LinkKey key) {
        boolean taken = keys.entrySet().stream()
                .anyMatch(other ->
                        !other.getKey().equals(user) && other.getValue().equals(key));
        if (!taken) {
            keys.put(user, key);
        }
        return !taken;
    }

    @Override
    public boolean removeKey(String user) {
        return keys.remove(user) != null;
    }

    @Override
    public OutletView status() {
        return new OutletView(
                endpoints(),
                keys.keySet().stream().sorted().map(ListedClients::client).toList(),
                new OutletView.RefusedView(1, 2, 3, 4, 5),
                0,
                0);
    }

    private static OutletView.ClientView client(String user) {
        return new OutletView.ClientView(
                "client-1", user, "127.0.0.1:9", "udp", 255, 1, Instant.EPOCH, 10, 20, 1, 2, 0, 0, 0.5);
    }

    @Override
    public boolean disconnect(String id) {
        return id.equals("client-1");
    }
}
