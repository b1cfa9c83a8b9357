package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * The peers of one UDP or DTLS endpoint, one for each sending address, as long as there is room. Datagrams come in on
 * one thread; the rest any thread.
 */
final class DatagramPeers<K> {
    private static final PeerRegistry.Limits LIMITS = new PeerRegistry.Limits(10_000, 2_500);

    private final PeerRegistry<K> peers;
    private final Outbound<K> way;
    private final Time time;

    /**
     * The shared send path and addressing between a datagram endpoint and its peers.
     *
     * @param place where the door is
     * @param address of a peer
     * @param out sends a peer one frame; false when there was no room
     */
    record Outbound<K>(EndpointPeer.Origin place, Function<K, PeerAddress> address, BiPredicate<K, byte[]> out) {}

    DatagramPeers(EndpointCounters counters, PeerHandler.Factory handlers, Outbound<K> way, Time time) {
        this.peers = new PeerRegistry<>(counters, handlers, LIMITS, time);
        this.way = way;
        this.time = time;
    }

    void deliver(K from, ByteBuffer datagram) {
        long now = time.nanos();
        EndpointPeer seat = peers.find(from);
        if (seat == null) {
            seat = admit(from, now);
        }
        if (seat != null) {
            seat.received(datagram, now);
        }
        peers.sweep(now);
    }

    private @Nullable EndpointPeer admit(K from, long now) {
        PeerAddress address = way.address().apply(from);
        return peers.add(
                from,
                address.host(),
                now,
                welcome -> new EndpointPeer(
                        way.place(), address, frame -> way.out().test(from, frame), welcome));
    }

    List<PeerStatus> status() {
        return peers.status();
    }

    /** All have gone. */
    void clear() {
        peers.clear();
    }
}
