package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Trust in a drone's identity so far: strongest evidence and authenticated link.
 *
 * @param strongest the best evidence that it ever showed
 * @param linkIdentity the identity of its authenticated link; null when it never had one
 * @param distinct somebody let it in beside a drone with the same hardware id, which therefore says nothing here
 */
public record IdentityTrust(
        IdentityEvidence strongest, @Nullable String linkIdentity, boolean distinct) {
    public static final IdentityTrust UNPROVED = new IdentityTrust(IdentityEvidence.ADDRESS, null, false);
    public static final IdentityTrust DISTINCT = new IdentityTrust(IdentityEvidence.ADDRESS, null, true);

    /** With what a session has just shown. */
    public IdentityTrust with(IdentityEvidence shown, @Nullable String identity) {
        IdentityEvidence counts = distinct && !shown.isProof() ? IdentityEvidence.ADDRESS : shown;
        return new IdentityTrust(strongest.orStronger(counts), identity == null ? linkIdentity : identity, distinct);
    }
}
