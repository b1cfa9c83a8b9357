package org.dronemap.proxy.session;

import java.util.ArrayDeque;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.signing.LinkGuard;
import org.jspecify.annotations.Nullable;

/**
 * Sends messages to one vehicle over one link, in its MAVLink version and signed where required. Owned by the session's
 * lane; the version comes from the endpoint's thread.
 */
final class VehicleSender {
    private static final int MOST_HELD = 256;

    private final Peer peer;
    private final FrameWriter version1 =
            new FrameWriter(MavlinkTarget.OWN_SYSTEM_ID, MavlinkTarget.OWN_COMPONENT_ID, 1);
    private final FrameWriter version2 =
            new FrameWriter(MavlinkTarget.OWN_SYSTEM_ID, MavlinkTarget.OWN_COMPONENT_ID, 2);
    private final ArrayDeque<Held> held = new ArrayDeque<>();
    private @Nullable LinkGuard guard;
    private FrameTap tap = FrameTap.NONE;
    private volatile boolean speaksVersion1;
    private volatile long sent;

    /** A message that waits; whether it may still go is judged when it goes. */
    private record Held(Message message, SendAuthority mandate) {}

    VehicleSender(Peer peer) {
        this.peer = peer;
    }

    PeerAddress address() {
        return peer.address();
    }

    /** Nobody but the vehicle can listen: this machine, a line plugged into it, or an encrypted link. */
    boolean isSafe() {
        return peer.isLocal() || peer.transport().equals("dtls");
    }

    /** From now on what goes out is signed by this guard's word. */
    void guardedBy(LinkGuard newGuard) {
        guard = newGuard;
    }

    void setVersion(int version) {
        speaksVersion1 = version == 1;
    }

    /** Who hears what is sent from now on. */
    void tapBy(FrameTap listener) {
        tap = listener;
    }

    /** Sends, or keeps in order what must wait for a change of keys; the oldest falls out of a full queue. */
    void send(Message message, SendAuthority mandate, long nowNanos) {
        if (guard != null && guard.holds(nowNanos)) {
            if (held.size() == MOST_HELD) {
                held.removeFirst();
            }
            held.addLast(new Held(message, mandate));
            return;
        }
        release();
        transmit(message, mandate);
    }

    /** Lets go what was held when the wait is over. */
    void releaseDue(long nowNanos) {
        if (!held.isEmpty() && (guard == null || !guard.holds(nowNanos))) {
            release();
        }
    }

    private void release() {
        while (!held.isEmpty()) {
            Held next = held.removeFirst();
            transmit(next.message(), next.mandate());
        }
    }

    private void transmit(Message message, SendAuthority mandate) {
        mandate.fence().pass(() -> tap.sent(put(message), mandate));
    }

    /** Sends at once what nobody but the vehicle may see: no tap, no log. */
    void sendSecret(Message message) {
        put(message);
    }

    /** Messages handed to the link. Any thread. */
    long sent() {
        return sent;
    }

    @SuppressWarnings("NonAtomicVolatileUpdate") // the session's lane alone writes
    private byte[] put(Message message) {
        sent++;
        byte[] frame = frame(message);
        peer.send(frame);
        return frame;
    }

    private byte[] frame(Message message) {
        FrameSigner signer = guard == null || speaksVersion1 ? null : guard.signer(message);
        if (signer != null) {
            return version2.frame(message, signer);
        }
        boolean fits = speaksVersion1 && message.messageId() < 256;
        return (fits ? version1 : version2).frame(message);
    }
}
