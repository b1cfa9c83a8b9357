package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * The peers at one door for datagrams: whoever sends one has a place as long as there is room. Datagrams come in on one
 * thread; the rest any thread.
 */
final class DatagramSeats<K> {
    private static final PeerBook.Limits LIMITS = new PeerBook.Limits(10_000, 2_500);

    private final PeerBook<K> peers;
    private final Way<K> way;
    private final Time time;

    /**
     * The shared send path and addressing between a datagram endpoint and its peers.
     *
     * @param place where the door is
     * @param address of a peer
     * @param out sends a peer one frame; false when there was no room
     */
    record Way<K>(Seat.Place place, Function<K, PeerAddress> address, BiPredicate<K, byte[]> out) {}

    DatagramSeats(EndpointCounters counters, PeerHandler.Factory handlers, Way<K> way, Time time) {
        this.peers = new PeerBook<>(counters, handlers, LIMITS, time);
        this.way = way;
        this.time = time;
    }

    void deliver(K from, ByteBuffer datagram) {
        long now = time.nanos();
        Seat seat = peers.find(from);
        if (seat == null) {
            seat = welcome(from, now);
        }
        if (seat != null) {
            seat.received(datagram, now);
        }
        peers.sweep(now);
    }

    private @Nullable Seat welcome(K from, long now) {
        PeerAddress address = way.address().apply(from);
        return peers.add(
                from,
                address.host(),
                now,
                welcome -> new Seat(way.place(), address, frame -> way.out().test(from, frame), welcome));
    }

    List<PeerStatus> status() {
        return peers.status();
    }

    /** All have gone. */
    void clear() {
        peers.clear();
    }
}
