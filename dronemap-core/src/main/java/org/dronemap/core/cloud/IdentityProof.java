package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.IdentityEvidence;
import org.jspecify.annotations.Nullable;

/** Proof of a vehicle's identity: an authenticated link, or messages signed with the drone's key. */
public sealed interface IdentityProof {
    IdentityEvidence evidence();

    /**
     * The identity that an authenticated link was opened with.
     *
     * @param drone that the identity was issued for, and no other; null where it shows which one that is
     */
    record OfLink(String identity, @Nullable DroneId drone) implements IdentityProof {
        public OfLink(String identity) {
            this(identity, null);
        }

        @Override
        public IdentityEvidence evidence() {
            return IdentityEvidence.LINK;
        }
    }

    /** Frames signed with the key of this drone. */
    record OfSignature(DroneId drone) implements IdentityProof {
        @Override
        public IdentityEvidence evidence() {
            return IdentityEvidence.SIGNATURE;
        }
    }
}
