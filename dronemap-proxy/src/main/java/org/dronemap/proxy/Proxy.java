package org.dronemap.proxy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.proxy.endpoint.Endpoint;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.record.Replays;
import org.dronemap.proxy.session.SessionTable;
import org.dronemap.proxy.session.Surroundings;

/** The links to vehicles: opens the configured endpoints and keeps them until closed. Any thread. */
public final class Proxy implements AutoCloseable {
    private final List<EndpointUrl> urls;
    private final SessionTable sessions;
    private final Replays replays;
    private final List<Endpoint> open = new ArrayList<>();

    /** One endpoint with its counts. */
    public record EndpointStatus(EndpointUrl url, EndpointCounters.Counts counts) {}

    public Proxy(CloudManager cloud, Lanes lanes, List<EndpointUrl> urls) {
        this.urls = List.copyOf(urls);
        sessions = new SessionTable(new Surroundings(cloud, lanes, System::nanoTime));
        replays = new Replays(sessions);
    }

    /**
     * Opens all endpoints or none.
     *
     * @throws IOException with a sentence that says which one and why
     */
    public synchronized void start() throws IOException {
        try {
            for (EndpointUrl url : urls) {
                open.add(Endpoint.open(url, sessions));
            }
        } catch (IOException e) {
            close();
            throw e;
        }
    }

    public synchronized List<EndpointStatus> endpoints() {
        return open.stream()
                .map(endpoint ->
                        new EndpointStatus(endpoint.url(), endpoint.counters().counts()))
                .toList();
    }

    /** Recordings that play or have played. */
    public Replays replays() {
        return replays;
    }

    /** Vehicles on links now. */
    public int sessionCount() {
        return sessions.openCount();
    }

    @Override
    public synchronized void close() {
        replays.close();
        open.forEach(Endpoint::close);
        open.clear();
    }
}
