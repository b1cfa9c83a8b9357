package org.dronemap.proxy.session;

import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.ClaimResult;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.IdentityProof;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.drone.Identification;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.IdentificationReader;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.dronemap.proxy.signing.LinkGuard;
import org.jspecify.annotations.Nullable;

/**
 * Binds a session to its drone in the cloud, by the identification and proof of the vehicle. Owned by the session's
 * lane.
 */
final class DroneBinder {
    private static final long PATIENCE_NANOS = 1_000_000_000L;
    /** Whoever is somebody else ever again is not believed, nor may it fill the list of drones. */
    private static final int MOST_CHANGES = 3;

    private static final long BETWEEN_CLAIMS_NANOS = 500_000_000L;

    private final SessionDependencies surroundings;
    private final LinkSelector links;
    private final AutopilotChannel conversation;
    private final AutopilotAdapter autopilot;
    private final VehicleStatus status;
    private final IdentificationRequester question;
    private final long bornNanos;
    private long notBeforeNanos;
    private int changes;
    private @Nullable String claimedHardware;
    private @Nullable IdentityProof shown;

    DroneBinder(SessionDependencies surroundings, LinkSelector links, AutopilotChannel conversation) {
        this.surroundings = surroundings;
        this.links = links;
        this.conversation = conversation;
        this.autopilot = conversation.autopilot();
        this.status = conversation.status();
        question = new IdentificationRequester(conversation.target(), surroundings.asks());
        bornNanos = surroundings.now();
        notBeforeNanos = bornNanos;
    }

    /** Asks the vehicle who it is as long as it did not say. */
    private void ask(long nowNanos, boolean bound) {
        if (status.version() == null) {
            question.sendDue(nowNanos, bound);
        }
    }

    /** Enough is known, or waited for, and the last claim is a moment ago. */
    boolean isDue(long nowNanos) {
        boolean known = links.best().label().replay()
                || status.version() != null
                || links.best().proof() != null
                || nowNanos - bornNanos >= PATIENCE_NANOS;
        return known && nowNanos - notBeforeNanos >= 0;
    }

    /** Claims the drone that all this speaks for; null while it has to stay outside. */
    @Nullable
    DroneLink claim(VehicleChannel channel, LinkGuard guard, long nowNanos) {
        notBeforeNanos = nowNanos + BETWEEN_CLAIMS_NANOS;
        Identification said = IdentificationReader.of(autopilot, status.type(), status.version());
        LinkOrigin from = links.best().label();
        if (!from.replay()
                && !guard.mayBind(surroundings.cloud().recognise(links.best().key(), said))) {
            return null;
        }
        claimedHardware = said.hardwareUid();
        shown = links.best().proof();
        LinkSession session = new LinkSession(
                links.best().key(),
                from.transport(),
                from.replay(),
                autopilot.vehicle() + " " + from.key().systemId(),
                channel);
        boolean trusted = surroundings.enrolment().admits(from);
        Claim claim = new Claim(session, said, shown, trusted, nowNanos - bornNanos);
        return surroundings.cloud().admit(claim) instanceof ClaimResult.Bound bound ? bound.link() : null;
    }

    /** True for a frame that names hardware which was not in the claim: it has to be judged anew. */
    boolean contradicts(Frame frame) {
        if (frame.messageId() != AutopilotVersion.ID || links.best().label().replay()) {
            return false;
        }
        AutopilotVersion version = AutopilotVersion.decode(frame);
        String said = IdentificationReader.of(autopilot, status.type(), version).hardwareUid();
        if (said == null || said.equals(claimedHardware) || changes == MOST_CHANGES) {
            return false;
        }
        changes++;
        status.version(version);
        return true;
    }

    /** A signature may come only after the vehicle was taken for somebody on its word; false when it is another one's. */
    boolean publishProof(DroneLink bound) {
        IdentityProof proof = links.best().proof();
        if (proof == null || proof.equals(shown)) {
            return true;
        }
        shown = proof;
        if (proof instanceof IdentityProof.OfSignature signature
                && !signature.drone().equals(bound.id())) {
            return false;
        }
        bound.proved(proof);
        return true;
    }

    /** {@code talkative}: it was heard a moment ago; {@code bound}: it is known which drone it is. */
    void talk(long now, boolean talkative, boolean bound) {
        if (talkative) {
            ask(now, bound);
        }
        if (!bound) {
            // Whoever is behind that address gets nothing else until it is known.
            return;
        }
        conversation.sendHeartbeat(now);
        if (talkative) {
            conversation.ask(now);
        }
    }
}
