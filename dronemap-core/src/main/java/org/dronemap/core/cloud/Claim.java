package org.dronemap.core.cloud;

import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityEvidence;
import org.jspecify.annotations.Nullable;

/**
 * A new session's claim to be a certain vehicle, with its evidence; resolved by IdentityResolver.
 *
 * @param proof null when it shows none
 * @param trusted unknown vehicles of this listener are let in by themselves
 * @param ageNanos how long ago it was first heard
 */
public record Claim(
        LinkSession session,
        Identification identification,
        @Nullable IdentityProof proof,
        boolean trusted,
        long ageNanos) {
    /** The best that it shows. */
    public IdentityEvidence evidence() {
        if (proof != null) {
            return proof.evidence();
        }
        return identification.hardwareUid() == null ? IdentityEvidence.ADDRESS : IdentityEvidence.HARDWARE;
    }
}
