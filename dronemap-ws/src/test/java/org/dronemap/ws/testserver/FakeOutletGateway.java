package org.dronemap.ws.testserver;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.LinkKey;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.ws.outlet.OutletGateway;
import org.dronemap.ws.outlet.OutletView;

/** An outlet that only remembers what it was told; as many clients are attached as anybody disconnects. */
final class FakeOutletGateway implements OutletGateway {
    private static final int MOST_PORTS_OF_A_USER = 3;

    private final Map<String, LinkKey> keys = new ConcurrentHashMap<>();
    private final Map<String, OutletView.PortView> ports = new ConcurrentHashMap<>();
    private int lastPort;

    @Override
    public List<String> endpoints() {
        return List.of("udpserver://127.0.0.1:14560");
    }

    @Override
    public void judgeAnew() {
        // Nobody is attached.
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
                keys.keySet().stream().sorted().map(FakeOutletGateway::client).toList(),
                List.copyOf(ports.values()),
                new OutletView.RefusedView(1, 2, 3, 4, 5, 6),
                0,
                0);
    }

    @Override
    public OutletView.PortView openPort(String user, String address, Duration time) {
        AddressRange allowed = AddressRange.parse(address);
        if (ports.values().stream().filter(port -> port.user().equals(user)).count() >= MOST_PORTS_OF_A_USER) {
            throw new IllegalStateException(
                    "You have " + MOST_PORTS_OF_A_USER + " personal ports already; close one first.");
        }
        String id = "port-" + ++lastPort;
        OutletView.PortView port = new OutletView.PortView(
                id,
                user,
                "udpserver://127.0.0.1:14561",
                allowed.toString(),
                null,
                0,
                Instant.EPOCH,
                Instant.EPOCH.plus(time));
        ports.put(id, port);
        return port;
    }

    @Override
    public boolean closePort(String id) {
        return ports.remove(id) != null;
    }

    @Override
    public void closePortsOf(String user) {
        ports.values().removeIf(port -> port.user().equals(user));
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
