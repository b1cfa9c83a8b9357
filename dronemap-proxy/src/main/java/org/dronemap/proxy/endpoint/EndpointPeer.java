package org.dronemap.proxy.endpoint;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * The implementation of Peer: sends to one address, passes on what it sends, and limits the work that it causes. A
 * stranger, who never sent a good frame, may cost little, and all strangers of one host share a purse. Bytes come in on
 * the endpoint's thread; the rest any thread.
 */
final class EndpointPeer implements Peer {
    /** About 10,000 messages a second: more than a radio, or a router of a hundred vehicles, ever sends. */
    private static final long UNITS_PER_SECOND = 3_200_000;
    /** About 1,300 messages: a vehicle that tells all its parameters at once. */
    private static final long FIRST_UNITS_PER_SECOND = 400_000;

    private static final long STRANGER_UNITS_PER_SECOND = 200_000;

    private final Origin place;
    private final FrameSender wire;
    private final PeerCounters counters;
    private final TokenBucket hostsStrangers;
    private final PeerHandler handler;
    private TokenBucket own;
    private boolean proven;
    private final String host;
    private volatile PeerAddress address;
    private volatile long lastReceivedNanos;
    private final AtomicBoolean ended = new AtomicBoolean();

    /** The properties that all peers of one endpoint share, and the path that a WebSocket was opened to. */
    record Origin(String transport, boolean local, boolean datagram, Optional<String> identity, String path) {
        Origin(String transport, boolean local, boolean datagram, Optional<String> identity) {
            this(transport, local, datagram, identity, "");
        }

        Origin(EndpointUrl url, boolean local, boolean datagram) {
            this(url.kind().transport(), local, datagram, Optional.empty());
        }

        /** Of a WebSocket that was opened to that path. */
        Origin at(String resource) {
            return new Origin(transport, local, datagram, identity, resource);
        }
    }

    EndpointPeer(Origin place, PeerAddress address, FrameSender wire, PeerRegistry.Admission welcome) {
        this.place = place;
        this.host = welcome.host();
        this.address = address;
        this.wire = wire;
        this.counters = new PeerCounters(welcome.counters());
        this.hostsStrangers = welcome.hostsStrangers();
        this.own = new TokenBucket(STRANGER_UNITS_PER_SECOND, welcome.now());
        this.lastReceivedNanos = welcome.now();
        this.handler = welcome.handlers().opened(this, counters);
    }

    /** False while it made too much work lately. */
    boolean isWithinBudget(long now) {
        return own.isOpen(now) && (proven || hostsStrangers.isOpen(now));
    }

    /** Takes bytes in, or drops and counts them when it made too much work lately. */
    void received(ByteBuffer bytes, long now) {
        lastReceivedNanos = now;
        if (!isWithinBudget(now)) {
            counters.throttled();
            return;
        }
        long frames = counters.framesIn();
        long broken = counters.brokenBytes();
        int length = bytes.remaining();
        handler.received(bytes);
        long cost = TokenBucket.cost(length, counters.framesIn() - frames, counters.brokenBytes() - broken);
        own.spend(cost);
        if (!proven) {
            hostsStrangers.spend(cost);
            if (counters.framesIn() > 0) {
                proven = true;
                own = TokenBucket.growing(FIRST_UNITS_PER_SECOND, UNITS_PER_SECOND, now);
            }
        }
    }

    /** Tells its handler and its wire once that it is gone. */
    void end() {
        if (ended.compareAndSet(false, true)) {
            handler.closed();
            wire.close();
        }
    }

    boolean isStranger() {
        return !proven;
    }

    long lastReceivedNanos() {
        return lastReceivedNanos;
    }

    FrameSender wire() {
        return wire;
    }

    PeerCounters counters() {
        return counters;
    }

    /** Whose places it counts among: its first address, or the identity that it proved. */
    String host() {
        return host;
    }

    void movedTo(PeerAddress next) {
        address = next;
    }

    @Override
    public PeerAddress address() {
        return address;
    }

    @Override
    public String transport() {
        return place.transport();
    }

    @Override
    public Optional<String> authenticatedIdentity() {
        return place.identity();
    }

    @Override
    public boolean isLocal() {
        return place.local();
    }

    @Override
    public boolean isDatagram() {
        return place.datagram();
    }

    @Override
    public String path() {
        return place.path();
    }

    @Override
    public boolean offer(byte[] frame) {
        boolean taken = wire.send(frame);
        if (taken) {
            counters.sent(true);
        }
        return taken;
    }

    @Override
    public void send(byte[] frame) {
        counters.sent(wire.send(frame));
    }
}
