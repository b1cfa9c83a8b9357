package org.dronemap.proxy.outlet;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.outlet.client.OutletCounts;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.proxy.outlet.rights.OutletCredential;
import org.jspecify.annotations.Nullable;

/**
 * A UDP port of the outlet for one user's program that cannot sign; it can only watch, from one address. Nothing there
 * is proved, so that it lets nobody do more than look. Any thread.
 */
final class PersonalPort implements OutletCredential, PeerHandler.Factory {
    private final OutletLoop loop;
    private final OutletCounts counts;
    private final Terms terms;
    private final LongSupplier nanoTime;
    private final LongAdder refused = new LongAdder();
    private volatile boolean closed;
    private volatile @Nullable PeerAddress first;

    /** {@code untilNanos} is {@code until} by the monotonic clock. */
    record Terms(String id, String user, AddressRange range, Instant since, Instant until, long untilNanos) {}

    PersonalPort(OutletLoop loop, OutletCounts counts, Terms terms, LongSupplier nanoTime) {
        this.loop = loop;
        this.counts = counts;
        this.terms = terms;
        this.nanoTime = nanoTime;
    }

    Terms terms() {
        return terms;
    }

    /** Frames from elsewhere. */
    long refused() {
        return refused.sum();
    }

    /** Whose it is; null until somebody speaks. */
    @Nullable
    PeerAddress first() {
        return first;
    }

    /** It is over, whatever comes. */
    void withdraw() {
        closed = true;
    }

    @Override
    public String user() {
        return terms.user();
    }

    @Override
    public boolean isWithdrawn() {
        return closed || nanoTime.getAsLong() - terms.untilNanos() >= 0;
    }

    @Override
    public @Nullable FrameSigner signer() {
        return null;
    }

    @Override
    public boolean onlyLooks() {
        return true;
    }

    /** Looks, whatever else the user may. */
    @Override
    public Principal rights(Principal user) {
        if (!user.may(Role.VIEWER)) {
            return user;
        }
        KeyScope looking = new KeyScope(user.scope().drones(), Set.of(Permission.VIEW));
        return new Principal(user.name(), Role.VIEWER, looking, user.key(), user.reach(), user.account());
    }

    /** The first that speaks from the range has it. */
    private synchronized boolean admits(PeerAddress address) {
        PeerAddress known = first;
        if (known == null && !isWithdrawn() && terms.range().contains(address.host())) {
            first = address;
            return true;
        }
        return address.equals(known) && !isWithdrawn();
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        return new PortPeerHandler(peer, counters);
    }

    /** One address at this port. Owned by the endpoint's thread. */
    private final class PortPeerHandler implements PeerHandler {
        private final Peer peer;
        private final PeerCounters counters;
        private final FrameReader reader = new FrameReader();
        private long taken;
        private long countedBroken;

        PortPeerHandler(Peer peer, PeerCounters counters) {
            this.peer = peer;
            this.counters = counters;
        }

        @Override
        public void received(ByteBuffer bytes) {
            taken = 0;
            reader.readDatagram(bytes, this::judge);
            long broken = reader.counts().skippedBytes();
            // As at the outlet itself: strangers stay strangers.
            counters.received(taken, broken - countedBroken);
            countedBroken = broken;
        }

        private void judge(Frame frame) {
            if (!frame.verified() || !admits(peer.address())) {
                refused.increment();
                counts.elsewhere();
                return;
            }
            taken++;
            if (!loop.receivedFromClient(peer, PersonalPort.this, frame)) {
                counters.droppedIn();
            }
        }

        @Override
        public void closed() {
            loop.gone(peer);
        }
    }
}
