package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.time.Time;

/**
 * An in-process peer without a socket, for simulated vehicles, robots and ground stations in tests and stepped time.
 * Its datagrams come in on one thread at a time; the rest any thread.
 */
public final class MemoryLink implements AutoCloseable {
    private final PeerAddress address;
    private final EndpointCounters counters = new EndpointCounters();
    private final DatagramPeers<PeerAddress> seats;
    private volatile boolean closed;

    /**
     * Nobody hears of it before its first datagram.
     *
     * @param handlers who takes in what it sends
     * @param address where it seems to be
     * @param toPeer gets each frame for it, on the thread that sends
     */
    public MemoryLink(PeerHandler.Factory handlers, PeerAddress address, Consumer<byte[]> toPeer, Time time) {
        this.address = address;
        EndpointPeer.Origin place = new EndpointPeer.Origin(EndpointUrl.parse("udpserver://127.0.0.1:0"), true, true);
        seats = new DatagramPeers<>(
                counters,
                handlers,
                new DatagramPeers.Outbound<>(place, peer -> peer, (peer, frame) -> sent(toPeer, frame)),
                time);
    }

    private boolean sent(Consumer<byte[]> toPeer, byte[] frame) {
        if (closed) {
            return false;
        }
        toPeer.accept(frame);
        return true;
    }

    /** It sends a datagram, which is lost after the close. The buffer may be used again. */
    public void received(ByteBuffer datagram) {
        if (!closed) {
            seats.deliver(address, datagram);
        }
    }

    /** It sends a datagram, which is lost after the close. */
    public void received(byte[] datagram) {
        received(ByteBuffer.wrap(datagram));
    }

    /** What went over it. */
    public EndpointCounters.Counts counts() {
        return counters.counts();
    }

    /** The peer, from its first datagram on. */
    public List<PeerStatus> peers() {
        return seats.status();
    }

    @Override
    public void close() {
        closed = true;
        seats.clear();
    }
}
