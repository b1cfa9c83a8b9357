package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.mavlink.FrameReader;

/** Takes what peers send, counts good frames as the sessions would, and answers each delivery with one byte. */
final class CountingPeerHandlers implements PeerHandler.Factory {
    static final byte[] GREETING = {7, 7, 7};

    private final List<CountingPeer> guests = new CopyOnWriteArrayList<>();

    /** One peer and what came of it. */
    static final class CountingPeer implements PeerHandler {
        private final Peer peer;
        private final PeerCounters counters;
        private final FrameReader reader = new FrameReader();
        private volatile int bytes;
        private volatile int frames;
        private volatile boolean closed;
        private FrameReader.Counts counted = reader.counts();

        CountingPeer(Peer peer, PeerCounters counters) {
            this.peer = peer;
            this.counters = counters;
        }

        @Override
        public void received(ByteBuffer received) {
            bytes += received.remaining();
            reader.read(received, frame -> frames++);
            FrameReader.Counts now = reader.counts();
            counters.received(now.goodFrames() - counted.goodFrames(), now.skippedBytes() - counted.skippedBytes());
            counted = now;
            peer.send(new byte[] {1});
        }

        @Override
        public void closed() {
            closed = true;
        }

        Peer peer() {
            return peer;
        }

        int bytes() {
            return bytes;
        }

        int frames() {
            return frames;
        }

        boolean isClosed() {
            return closed;
        }
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        CountingPeer guest = new CountingPeer(peer, counters);
        guests.add(guest);
        return guest;
    }

    @Override
    public byte[] greeting() {
        return GREETING.clone();
    }

    List<CountingPeer> guests() {
        return guests;
    }

    int bytes() {
        return guests.stream().mapToInt(CountingPeer::bytes).sum();
    }
}
