package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Kinds of evidence of a vehicle's identity: address, hardware id, signature, authenticated link; weakest first. */
@Stored(names = "ADDRESS HARDWARE SIGNATURE LINK")
public enum IdentityEvidence {
    /** The address and system id that it had before. */
    ADDRESS,
    /** The board's own id: not secret, sometimes not unique; guards against accidents, not attackers. */
    HARDWARE,
    /** Frames signed with the vehicle's key. */
    SIGNATURE,
    /** A link that was opened with the vehicle's own secret. */
    LINK;

    /** True when nobody else can show it; a drone that once showed this is never again taken for less. */
    public boolean isProof() {
        return compareTo(SIGNATURE) >= 0;
    }

    public IdentityEvidence orStronger(IdentityEvidence other) {
        return compareTo(other) >= 0 ? this : other;
    }
}
