package org.dronemap.ws.security;

import java.time.Instant;
import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/**
 * An authenticated caller, with the proof of identity (session, access key or password) and when it expires.
 *
 * @param tokenHash the hash of the session's token or of the key; null for a password
 * @param until when the proof ends by itself; null: it does not
 * @param passwordSeen the user still has a password that somebody else has seen
 */
public record AuthenticatedCaller(
        Principal principal,
        Proof proof,
        @Nullable String tokenHash,
        @Nullable Instant until,
        boolean passwordSeen) {

    /** Kinds of credentials that a caller authenticated with: session, access key or password. */
    public enum Proof {
        SESSION,
        KEY,
        PASSWORD
    }

    /** The hash of the session's token; null for a key or a password. */
    public @Nullable String sessionHash() {
        return proof == Proof.SESSION ? tokenHash : null;
    }
}
