package org.dronemap.ws.testserver;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.ws.link.EndpointView;
import org.dronemap.ws.link.LinkTrafficView;
import org.dronemap.ws.link.VehicleEndpointGateway;

/** Opens nothing: lists what it was told to keep, one configured endpoint before it. */
public final class FakeVehicleLinkGateway implements VehicleEndpointGateway {
    public static final String CONFIGURED = "udpserver://127.0.0.1:14550";

    private final Map<String, String> kept = new LinkedHashMap<>(Map.of("configured-1", CONFIGURED));
    private final List<String> disconnected = new CopyOnWriteArrayList<>();

    @Override
    public synchronized List<Status> all() {
        List<Status> all = new ArrayList<>();
        kept.forEach((id, url) -> all.add(new Status(
                id,
                url,
                url.substring(0, 3),
                url.startsWith("serial") ? "failed" : "open",
                url.startsWith("serial") ? "there is no device" : null,
                new EndpointView.Counts(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11L),
                List.of(new EndpointView.PeerView("127.0.0.1:1", null, 2, 3, 4, 5, 6, 7, 0.5)))));
        return all;
    }

    @Override
    public String checked(String url) {
        if (!url.contains("://")) {
            throw new IllegalArgumentException("\"" + url + "\" is no endpoint.");
        }
        return url;
    }

    @Override
    public synchronized void keep(String id, String url) {
        if (kept.containsValue(url)) {
            throw new IllegalStateException("There is an endpoint " + url + " already.");
        }
        kept.put(id, url);
    }

    @Override
    public synchronized boolean remove(String id) {
        return kept.remove(id) != null;
    }

    @Override
    public void disconnect(String identity) {
        disconnected.add(identity);
    }

    /** Whose links were ended. */
    public List<String> disconnected() {
        return disconnected;
    }

    @Override
    public List<LinkTrafficView> traffic() {
        return List.of(
                new LinkTrafficView("drone-1", "127.0.0.1", 14601, 1, "udp", 100, 50, 3, 2, 1, 0),
                new LinkTrafficView("drone-2", "127.0.0.1", 14602, 1, "udp", 1, 0, 0, 0, 0, 0));
    }

    @Override
    public Map<String, Long> refusedMessages() {
        return Map.of("broken", 3L, "notBelieved", 4L);
    }
}
