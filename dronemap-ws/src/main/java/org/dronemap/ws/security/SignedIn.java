package org.dronemap.ws.security;

import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * Who asks and how that was proved.
 *
 * @param sessionHash the hash of the session's token; null for a key or a password
 */
public record SignedIn(
        Principal principal, Proof proof, @Nullable String sessionHash) {

    /** What the caller showed. */
    public enum Proof {
        SESSION,
        KEY,
        PASSWORD
    }
}
