package org.dronemap.proxy.endpoint;

import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * The peers of one endpoint, longest silent first: bounded in all and per host, so that one address cannot take every place.
 * Strangers, who never sent a good frame, lose their place sooner. Times are monotonic ns. Thread-safe.
 */
final class PeerBook<K> {
    private static final long IDLE_NANOS = 60_000_000_000L;
    private static final long STRANGER_IDLE_NANOS = 10_000_000_000L;
    private static final long BETWEEN_SWEEPS_NANOS = 1_000_000_000L;
    private static final long SHORTEST_BETWEEN_SWEEPS_NANOS = 100_000_000L;
    private static final long STRANGERS_UNITS_PER_SECOND = 2_000_000;

    private final EndpointCounters counters;
    private final PeerHandler.Factory handlers;
    private final Limits limits;
    // guarded by this
    private final LinkedHashMap<K, Seat> seats = new LinkedHashMap<>(64, 0.75f, true);
    private final Map<String, Host> hosts = new HashMap<>();
    private volatile long sweptNanos = System.nanoTime();

    /** How many peers there may be. */
    record Limits(int peers, int perHost) {}

    /** What a new seat needs. */
    record Welcome(
            EndpointCounters counters, PeerHandler.Factory handlers, String host, Allowance hostsStrangers, long now) {}

    /** What the peers of one host share. */
    private static final class Host {
        private final Allowance strangers;
        private int peers;

        Host(long now) {
            strangers = new Allowance(STRANGERS_UNITS_PER_SECOND, now);
        }
    }

    PeerBook(EndpointCounters counters, PeerHandler.Factory handlers, Limits limits) {
        this.counters = counters;
        this.handlers = handlers;
        this.limits = limits;
    }

    synchronized @Nullable Seat find(K key) {
        return seats.get(key);
    }

    /** A place for a new peer of that host; null, counted, when there is none. */
    synchronized @Nullable Seat add(K key, String host, long now, Function<Welcome, Seat> maker) {
        Host its = hosts.get(host);
        if (seats.size() >= limits.peers() || (its != null && its.peers >= limits.perHost())) {
            sweep(now, STRANGER_IDLE_NANOS);
            its = hosts.get(host);
            if (seats.size() >= limits.peers() || (its != null && its.peers >= limits.perHost())) {
                counters.refusedPeer();
                return null;
            }
        }
        if (its == null) {
            its = new Host(now);
            hosts.put(host, its);
        }
        Seat seat = maker.apply(new Welcome(counters, handlers, host, its.strangers, now));
        its.peers++;
        seats.put(key, seat);
        counters.peers(seats.size());
        return seat;
    }

    /** Ends the longest silent peer of that host when it has all that it may have. */
    synchronized void makeRoomFor(String host) {
        Host its = hosts.get(host);
        if (its != null && its.peers >= limits.perHost()) {
            seats.entrySet().stream()
                    .filter(entry -> entry.getValue().host().equals(host))
                    .map(Map.Entry::getKey)
                    .findFirst()
                    .ifPresent(this::remove);
        }
    }

    /** Ends every peer of that host. */
    synchronized void removeAllOf(String host) {
        List<K> its = seats.entrySet().stream()
                .filter(entry -> entry.getValue().host().equals(host))
                .map(Map.Entry::getKey)
                .toList();
        its.forEach(this::remove);
    }

    /** The peer is gone. */
    synchronized void remove(K key) {
        Seat seat = seats.remove(key);
        if (seat != null) {
            leave(seat);
        }
    }

    /** Ends those that have been silent for a minute; at most once a second. */
    void sweep(long now) {
        // Asked for every datagram: without the lock.
        if (now - sweptNanos >= BETWEEN_SWEEPS_NANOS) {
            sweep(now, IDLE_NANOS);
        }
    }

    private synchronized void sweep(long now, long strangerIdleNanos) {
        if (now - sweptNanos < SHORTEST_BETWEEN_SWEEPS_NANOS) {
            return;
        }
        sweptNanos = now;
        Iterator<Seat> oldest = seats.values().iterator();
        while (oldest.hasNext()) {
            Seat seat = oldest.next();
            long silent = now - seat.lastHeardNanos();
            if (silent < strangerIdleNanos) {
                break;
            }
            if (seat.isStranger() || silent >= IDLE_NANOS) {
                oldest.remove();
                leave(seat);
            }
        }
    }

    private void leave(Seat seat) {
        seat.end();
        String host = seat.host();
        Host its = hosts.get(host);
        if (its != null && --its.peers == 0) {
            hosts.remove(host);
        }
        counters.peers(seats.size());
    }

    /** Ends all. */
    synchronized void clear() {
        seats.values().forEach(Seat::end);
        seats.clear();
        hosts.clear();
        counters.peers(0);
    }

    /** All, the longest silent first. */
    synchronized List<PeerStatus> status() {
        long now = System.nanoTime();
        return seats.values().stream().map(seat -> PeerStatus.of(seat, now)).toList();
    }
}
