package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.process.PeerPattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Wraps peer handlers to record whose bytes are processed, and ignores peers whose bytes crashed the server before. Any
 * thread.
 */
final class WatchedPeerHandlers implements PeerHandler.Factory {
    private static final Logger LOG = LoggerFactory.getLogger(WatchedPeerHandlers.class);

    private final PeerHandler.Factory inner;
    private final PeerCrashGuard watch;

    WatchedPeerHandlers(PeerHandler.Factory inner, PeerCrashGuard watch) {
        this.inner = inner;
        this.watch = watch;
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        PeerPattern name = nameOf(peer.address());
        if (watch.precautions().refuses(name)) {
            LOG.warn("Nothing is taken from {}: the server ended while it worked on what that peer had sent", name);
            return new Discarding();
        }
        return new Watched(peer, inner.opened(peer, counters));
    }

    private static PeerPattern nameOf(PeerAddress address) {
        return PeerPattern.at(address.host(), address.port());
    }

    @Override
    public byte[] greeting() {
        return inner.greeting();
    }

    @Override
    public PeerMessageFormat speech() {
        return inner.speech();
    }

    @Override
    public boolean acceptsPath(String path) {
        return inner.acceptsPath(path);
    }

    private static final class Discarding implements PeerHandler {
        @Override
        public void received(ByteBuffer bytes) {
            bytes.position(bytes.limit());
        }

        @Override
        public void closed() {
            // It was never open.
        }
    }

    private final class Watched implements PeerHandler {
        private final Peer peer;
        private final PeerHandler handler;
        private PeerAddress named;
        private String name;

        Watched(Peer peer, PeerHandler handler) {
            this.peer = peer;
            this.handler = handler;
            this.named = peer.address();
            this.name = nameOf(named).text();
        }

        @Override
        public void received(ByteBuffer bytes) {
            PeerAddress now = peer.address();
            if (!now.equals(named)) {
                named = now;
                name = nameOf(now).text();
            }
            watch.atWork().at(name, () -> handler.received(bytes));
        }

        @Override
        public void closed() {
            handler.closed();
        }
    }
}
