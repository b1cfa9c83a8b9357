package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * How well a drone has proved its identity so far: strongest evidence and authenticated link.
 *
 * @param strongest the best evidence that it ever showed
 * @param linkIdentity the identity of its authenticated link; null when it never had one
 * @param distinct somebody let it in beside a drone with the same hardware id, which therefore says nothing here
 */
public record IdentityTrust(Evidence strongest, @Nullable String linkIdentity, boolean distinct) {
    public static final IdentityTrust UNPROVED = new IdentityTrust(Evidence.ADDRESS, null, false);
    public static final IdentityTrust DISTINCT = new IdentityTrust(Evidence.ADDRESS, null, true);

    /** With what a session has just shown. */
    public IdentityTrust with(Evidence shown, @Nullable String identity) {
        Evidence counts = distinct && !shown.isProof() ? Evidence.ADDRESS : shown;
        return new IdentityTrust(strongest.orStronger(counts), identity == null ? linkIdentity : identity, distinct);
    }
}
