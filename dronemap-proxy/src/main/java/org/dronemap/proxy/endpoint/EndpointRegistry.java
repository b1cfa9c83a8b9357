package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The configured and added endpoints of one proxy or the outlet; one that cannot open keeps the reason and is retried.
 * Any thread.
 */
public final class EndpointRegistry implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(EndpointRegistry.class);
    private static final int MOST = 64;
    private static final Duration RETRY = Duration.ofSeconds(5);
    private static final Duration BETWEEN_LOOKS = Duration.ofSeconds(1);
    private static final EndpointCounters.Counts NOTHING = new EndpointCounters().counts();

    private final PeerHandler.Factory handlers;
    private final EndpointSecurity doors;
    private final Time time;
    private final Duration retry;
    // guarded by this
    private final Map<String, Entry> links = new LinkedHashMap<>();
    private @Nullable Worker retries;

    /** An endpoint that is wanted, open or not. */
    private static final class Entry {
        private EndpointUrl wanted;
        private @Nullable Endpoint endpoint;
        private String failure = "";

        private boolean wasOpen;

        Entry(EndpointUrl wanted) {
            this.wanted = wanted;
        }

        void is(Endpoint open) {
            endpoint = open;
            wasOpen = true;
        }

        boolean isBroken() {
            return wasOpen && (endpoint == null || endpoint.isOver());
        }
    }

    /**
     * One endpoint and how it is doing.
     *
     * @param url as wanted, or with the port that was really taken
     */
    public record Status(
            String id,
            EndpointUrl url,
            EndpointState state,
            EndpointCounters.Counts counts,
            OptionalLong kernelDrops,
            List<PeerStatus> peers) {}

    public EndpointRegistry(PeerHandler.Factory handlers, EndpointSecurity doors, Time time) {
        this(handlers, doors, time, RETRY);
    }

    /** {@code retry}: between two attempts to open what could not open. */
    EndpointRegistry(PeerHandler.Factory handlers, EndpointSecurity doors, Time time, Duration retry) {
        this.handlers = new WatchedPeerHandlers(handlers, doors.watch());
        this.doors = doors;
        this.time = time;
        this.retry = retry;
    }

    /**
     * Opens an endpoint now; when it cannot, nothing is kept.
     *
     * @throws IOException with a sentence that says why
     */
    public synchronized void open(String id, EndpointUrl url) throws IOException {
        Entry link = entry(id, url);
        link.is(Endpoint.open(url, handlers, doors, time));
        links.put(id, link);
        startRetries();
    }

    /**
     * Keeps an endpoint from now on, and tries again when it cannot open.
     *
     * @throws IllegalStateException with a sentence when there are too many, or that id or URL is there already
     */
    public synchronized void retryLater(String id, EndpointUrl url) {
        Entry link = entry(id, url);
        links.put(id, link);
        attempt(link);
        startRetries();
    }

    private void startRetries() {
        if (retries == null) {
            retries = time.worker("links", 1);
            ScheduledTask unused = retries.every(retry, retry, this::retry);
            ScheduledTask unusedToo = retries.every(BETWEEN_LOOKS, BETWEEN_LOOKS, this::openAgain);
        }
    }

    /** At the port that it had, also when any would have done. */
    private synchronized void openAgain() {
        for (Entry link : links.values()) {
            Endpoint ended = link.endpoint;
            if (ended != null && ended.isOver()) {
                LOG.error("{} ended by itself; it is opened again", ended.url());
                link.wanted = ended.url();
                link.endpoint = null;
                ended.close();
                attempt(link);
            }
        }
    }

    private Entry entry(String id, EndpointUrl url) {
        if (links.size() >= MOST) {
            throw new IllegalStateException("There are " + MOST + " endpoints already; remove one first.");
        }
        if (links.containsKey(id) || isThere(url)) {
            throw new IllegalStateException("There is an endpoint " + url + " already.");
        }
        return new Entry(url);
    }

    private boolean isThere(EndpointUrl url) {
        boolean anyPort = url.kind().isListener() && url.port() == 0;
        return !anyPort
                && links.values().stream()
                        .anyMatch(link -> link.wanted.equals(url)
                                || (link.endpoint != null && link.endpoint.url().equals(url)));
    }

    private synchronized void retry() {
        // attempt() catches: the schedule never ends by a failure.
        links.values().stream().filter(link -> link.endpoint == null).forEach(this::attempt);
    }

    private void attempt(Entry link) {
        try {
            Endpoint opened = Endpoint.open(link.wanted, handlers, doors, time);
            link.is(opened);
            LOG.info("{} is open", opened.url());
        } catch (IOException | RuntimeException e) {
            String why = String.valueOf(e.getMessage());
            if (!why.equals(link.failure)) {
                LOG.warn("{} It is tried again every {} s.", why, retry.toSeconds());
            }
            link.failure = why;
        }
    }

    /** False when there is none. */
    public boolean remove(String id) {
        Entry link;
        synchronized (this) {
            link = links.remove(id);
        }
        if (link == null) {
            return false;
        }
        Endpoint endpoint = link.endpoint;
        if (endpoint != null) {
            endpoint.close();
        }
        return true;
    }

    /** Ends every link that was proven with that identity: its key is no longer good. */
    public synchronized void disconnect(String identity) {
        for (Entry link : links.values()) {
            Endpoint endpoint = link.endpoint;
            if (endpoint != null) {
                endpoint.disconnect(identity);
            }
        }
    }

    /** Those that listened and do not any more, by their URLs. */
    public synchronized List<String> broken() {
        return links.values().stream()
                .filter(Entry::isBroken)
                .map(link -> link.wanted.toString())
                .toList();
    }

    /** All, in the order in which they were added. */
    public synchronized List<Status> all() {
        List<Status> all = new ArrayList<>();
        links.forEach((id, link) -> all.add(status(id, link)));
        return all;
    }

    private static Status status(String id, Entry link) {
        Endpoint endpoint = link.endpoint;
        return endpoint == null
                ? new Status(
                        id,
                        link.wanted,
                        new EndpointState(EndpointState.Phase.FAILED, link.failure),
                        NOTHING,
                        OptionalLong.empty(),
                        List.of())
                : new Status(
                        id,
                        endpoint.url(),
                        endpoint.state(),
                        endpoint.counters().counts(),
                        endpoint.kernelDrops(),
                        endpoint.peers());
    }

    @Override
    public synchronized void close() {
        if (retries != null) {
            retries.close();
            retries = null;
        }
        links.values().forEach(link -> {
            if (link.endpoint != null) {
                link.endpoint.close();
            }
        });
        links.clear();
    }
}
