package org.dronemap.proxy.outlet;

import java.nio.ByteBuffer;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.signing.SignatureVerdict;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.outlet.client.OutletCounts;
import org.dronemap.proxy.outlet.rights.OutletKeys;
import org.dronemap.proxy.outlet.rights.UserKey;
import org.jspecify.annotations.Nullable;

/**
 * Receives bytes from one address at the outlet, and passes on only frames signed with a user's key. Owned by the
 * endpoint's thread.
 */
final class OutletPeerHandler implements PeerHandler {
    private final OutletLoop loop;
    private final OutletKeys keys;
    private final OutletCounts counts;
    private final Peer peer;
    private final PeerCounters counters;
    private final FrameReader reader = new FrameReader();
    private @Nullable UserKey key;
    private long taken;
    private long countedBroken;

    OutletPeerHandler(OutletLoop loop, OutletKeys keys, OutletCounts counts, Peer peer, PeerCounters counters) {
        this.loop = loop;
        this.keys = keys;
        this.counts = counts;
        this.peer = peer;
        this.counters = counters;
    }

    @Override
    public void received(ByteBuffer bytes) {
        taken = 0;
        if (peer.isDatagram()) {
            reader.readDatagram(bytes, this::judge);
        } else {
            reader.read(bytes, this::judge);
        }
        long broken = reader.counts().skippedBytes();
        // What strangers send counts as no frame, so that they stay strangers.
        counters.received(taken, broken - countedBroken);
        countedBroken = broken;
    }

    private void judge(Frame frame) {
        UserKey before = key;
        UserKey owner = before;
        SignatureVerdict verdict =
                before == null || before.isWithdrawn() ? SignatureVerdict.BAD_SIGNATURE : before.judge(frame);
        if (verdict == SignatureVerdict.BAD_SIGNATURE) {
            // The address may be another user's program's by now, which does not wait until the one before is
            // forgotten.
            owner = keys.owner(frame).orElse(null);
            verdict = owner != null
                    ? owner.judge(frame)
                    : frame.signed() ? SignatureVerdict.BAD_SIGNATURE : SignatureVerdict.UNSIGNED;
        }
        if (owner == null || !verdict.isValid()) {
            counts.refused(verdict);
            return;
        }
        key = owner;
        taken++;
        if (!loop.receivedFromClient(peer, owner, frame)) {
            counters.droppedIn();
        }
    }

    @Override
    public void closed() {
        loop.gone(peer);
    }
}
