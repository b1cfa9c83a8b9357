package org.dronemap.proxy.endpoint;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * The peers of one endpoint, limited in all and per host, so that one address cannot take every place. Strangers, who
 * never sent a good frame, lose their place sooner. Times are monotonic ns. Thread-safe.
 */
final class PeerRegistry<K> {
    private static final long IDLE_NANOS = 60_000_000_000L;
    private static final long STRANGER_IDLE_NANOS = 10_000_000_000L;
    private static final long BETWEEN_SWEEPS_NANOS = 1_000_000_000L;
    private static final long SHORTEST_BETWEEN_SWEEPS_NANOS = 100_000_000L;
    private static final long STRANGERS_UNITS_PER_SECOND = 2_000_000;

    private final EndpointCounters counters;
    private final PeerHandler.Factory handlers;
    private final Limits limits;
    private final Time time;
    // guarded by this
    private final LinkedHashMap<K, EndpointPeer> seats = new LinkedHashMap<>(64, 0.75f, true);
    private final Map<String, Host> hosts = new HashMap<>();
    private volatile long sweptNanos;

    /** The greatest number of peers, in all and per host. */
    record Limits(int peers, int perHost) {}

    /** The counters, handlers and shared budget that a new peer is made with. */
    record Admission(
            EndpointCounters counters,
            PeerHandler.Factory handlers,
            String host,
            TokenBucket hostsStrangers,
            long now) {}

    /** The state that all peers of one host share. */
    private static final class Host {
        private final TokenBucket strangers;
        private int peers;

        Host(long now) {
            strangers = new TokenBucket(STRANGERS_UNITS_PER_SECOND, now);
        }
    }

    PeerRegistry(EndpointCounters counters, PeerHandler.Factory handlers, Limits limits, Time time) {
        this.counters = counters;
        this.handlers = handlers;
        this.limits = limits;
        this.time = time;
        this.sweptNanos = time.nanos();
    }

    synchronized @Nullable EndpointPeer find(K key) {
        return seats.get(key);
    }

    /** A place for a new peer of that host; null, counted, when there is none. */
    @Nullable
    EndpointPeer add(K key, String host, long now, Function<Admission, EndpointPeer> maker) {
        List<EndpointPeer> gone = new ArrayList<>();
        EndpointPeer seat = add(key, host, now, maker, gone);
        end(gone);
        return seat;
    }

    private synchronized @Nullable EndpointPeer add(
            K key, String host, long now, Function<Admission, EndpointPeer> maker, List<EndpointPeer> gone) {
        if (isFull(host)) {
            gone.addAll(sweep(now, STRANGER_IDLE_NANOS));
            if (isFull(host)) {
                counters.refusedPeer();
                return null;
            }
        }
        Host its = hosts.computeIfAbsent(host, first -> new Host(now));
        EndpointPeer seat = maker.apply(new Admission(counters, handlers, host, its.strangers, now));
        its.peers++;
        seats.put(key, seat);
        counters.peers(seats.size());
        return seat;
    }

    private boolean isFull(String host) {
        Host its = hosts.get(host);
        return seats.size() >= limits.peers() || (its != null && its.peers >= limits.perHost());
    }

    /** Ends the longest silent peer of that host when it has all that it may have. */
    void makeRoomFor(String host) {
        end(detachOldest(host));
    }

    private synchronized List<EndpointPeer> detachOldest(String host) {
        Host its = hosts.get(host);
        if (its == null || its.peers < limits.perHost()) {
            return List.of();
        }
        return detach(keysOf(host).stream().limit(1).toList());
    }

    /** Ends every peer of that host. */
    void removeAllOf(String host) {
        end(detachAllOf(host));
    }

    private synchronized List<EndpointPeer> detachAllOf(String host) {
        return detach(keysOf(host));
    }

    private List<K> keysOf(String host) {
        return seats.entrySet().stream()
                .filter(entry -> entry.getValue().host().equals(host))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** The peer is gone. */
    void remove(K key) {
        end(detachOne(key));
    }

    private synchronized List<EndpointPeer> detachOne(K key) {
        return detach(List.of(key));
    }

    /** Ends those that have been silent for a minute; at most once a second. */
    void sweep(long now) {
        // Asked for every datagram: without the lock.
        if (now - sweptNanos >= BETWEEN_SWEEPS_NANOS) {
            end(sweep(now, IDLE_NANOS));
        }
    }

    private synchronized List<EndpointPeer> sweep(long now, long strangerIdleNanos) {
        List<K> silent = new ArrayList<>();
        if (now - sweptNanos < SHORTEST_BETWEEN_SWEEPS_NANOS) {
            return List.of();
        }
        sweptNanos = now;
        for (Map.Entry<K, EndpointPeer> oldest : seats.entrySet()) {
            long silentNanos = now - oldest.getValue().lastReceivedNanos();
            if (silentNanos < strangerIdleNanos) {
                break;
            }
            if (oldest.getValue().isStranger() || silentNanos >= IDLE_NANOS) {
                silent.add(oldest.getKey());
            }
        }
        return detach(silent);
    }

    private List<EndpointPeer> detach(List<K> keys) {
        List<EndpointPeer> taken = new ArrayList<>(keys.size());
        for (K key : keys) {
            EndpointPeer seat = seats.remove(key);
            if (seat != null) {
                taken.add(seat);
                Host its = hosts.get(seat.host());
                if (its != null && --its.peers == 0) {
                    hosts.remove(seat.host());
                }
            }
        }
        counters.peers(seats.size());
        return taken;
    }

    /** Ends all. */
    void clear() {
        end(detachAll());
    }

    private synchronized List<EndpointPeer> detachAll() {
        return detach(List.copyOf(seats.keySet()));
    }

    /** Never under the lock: a wire that closes may wait for a thread that wants to tell here that its peer is gone. */
    private static void end(List<EndpointPeer> gone) {
        gone.forEach(EndpointPeer::end);
    }

    /** All, the longest silent first. */
    synchronized List<PeerStatus> status() {
        long now = time.nanos();
        return seats.values().stream().map(seat -> PeerStatus.of(seat, now)).toList();
    }
}
