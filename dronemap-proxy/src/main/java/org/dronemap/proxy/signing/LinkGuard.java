package org.dronemap.proxy.signing;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.jspecify.annotations.Nullable;

/**
 * Verifies the signatures of frames received over one vehicle link before anything acts on them, and signs sent ones.
 * Owned by the session's lane.
 */
public final class LinkGuard {
    private static final long BETWEEN_SEARCHES_NANOS = 100_000_000L;

    private final KeyringRegistry keyrings;
    private final int linkId;
    private final BooleanSupplier safe;
    private @Nullable DroneId bound;
    private @Nullable Keyring claimed;
    private boolean signedHere;
    private boolean proven;
    private long lastSearchNanos;
    private boolean searched;

    LinkGuard(KeyringRegistry keyrings, int linkId, BooleanSupplier safe) {
        this.keyrings = keyrings;
        this.linkId = linkId;
        this.safe = safe;
    }

    /** A key may be sent here now without anybody hearing it. Any thread. */
    boolean isSafe() {
        return safe.getAsBoolean();
    }

    public FrameAdmission judge(Frame frame, long nowNanos) {
        if (frame.messageId() == SetupSigning.ID) {
            return FrameAdmission.REFUSED;
        }
        if (!proven) {
            search(frame, nowNanos);
        }
        Keyring ring = keyring();
        if (ring == null) {
            return FrameAdmission.ADMITTED;
        }
        FrameAdmission admission = ring.admit(frame, nowNanos);
        proven |= admission == FrameAdmission.PROVEN;
        return admission;
    }

    /** Whose key signs here; at most ten looks a second, so that noise does not keep us busy. */
    private void search(Frame frame, long nowNanos) {
        if (!frame.signed() || (searched && nowNanos - lastSearchNanos < BETWEEN_SEARCHES_NANOS)) {
            return;
        }
        searched = true;
        lastSearchNanos = nowNanos;
        Keyring found = keyrings.signerOf(frame);
        if (found != null) {
            claimed = found;
            signedHere = true;
        }
    }

    /** The key of another drone than the one that it is bound to signs here: it must be bound anew. */
    public boolean contradicts() {
        return bound != null
                && claimed != null
                && !claimed.drone().equals(bound)
                && keyrings.find(claimed.drone()) == claimed;
    }

    private @Nullable Keyring keyring() {
        return bound == null ? claimed : keyrings.find(bound);
    }

    /** The drone whose key has validly signed what came here: proof of who it is. */
    public Optional<DroneId> signer() {
        Keyring ring = keyring();
        return proven && ring != null ? Optional.of(ring.drone()) : Optional.empty();
    }

    /**
     * False while this link speaks in the name of a drone that must sign, and has not, and while it brings nothing but old
     * messages of a drone: copies that came over another link first prove nothing, nor do they come from a stranger.
     */
    public boolean mayBind(Optional<DroneId> recognised) {
        if (claimed == null) {
            claimed = recognised.map(keyrings::find).orElse(null);
        }
        return claimed == null || proven || !(claimed.isRequired() || (signedHere && claimed.isLookedAt()));
    }

    public void bound(DroneId drone, int systemId) {
        bound = drone;
        keyrings.links(drone).add(this);
        Keyring ring = keyrings.find(drone);
        if (ring != null && proven) {
            ring.bound(systemId);
        }
    }

    public void unbound() {
        leave();
        bound = null;
    }

    /** Signs a message that goes out; null: it goes unsigned. Before the vehicle has proven itself only heartbeats are. */
    public @Nullable FrameSigner signer(Message message) {
        Keyring ring = keyring();
        boolean may = bound != null || proven || message.messageId() == Heartbeat.ID;
        return ring == null || !may ? null : ring.signer(linkId);
    }

    /** True while nobody knows which key the vehicle reads with: what goes out waits. */
    public boolean holds(long nowNanos) {
        Keyring ring = bound == null ? null : keyring();
        return ring != null && ring.holds(nowNanos);
    }

    /** The vehicle's own words may be its answer to a new key. */
    public void textReceived(String text) {
        Keyring ring = bound == null ? null : keyring();
        if (ring != null) {
            ring.textReceived(text);
        }
    }

    /** A key to be sent to the vehicle now and never to be shown to anybody else; null: none. */
    public @Nullable SetupSigning advance(int systemId, int componentId, long nowNanos) {
        Keyring ring = bound == null ? null : keyring();
        Keyring.Request request = ring == null ? null : ring.advance(this, nowNanos);
        if (request == null) {
            return null;
        }
        byte[] key =
                request.key() == null ? new byte[LinkKey.BYTES] : request.key().secret();
        int[] secret = new int[key.length];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = key[i] & 0xFF;
        }
        return new SetupSigning(systemId, componentId, secret, request.timestamp());
    }

    /** The link has ended. */
    public void leave() {
        if (bound != null) {
            keyrings.links(bound).remove(this);
        }
    }
}
