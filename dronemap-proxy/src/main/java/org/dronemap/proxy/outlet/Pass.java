package org.dronemap.proxy.outlet;

import org.dronemap.core.access.Principal;
import org.dronemap.mavlink.FrameSigner;
import org.jspecify.annotations.Nullable;

/** By what a program was let in: its user's key, or a port of the user's own. Any thread. */
sealed interface Pass permits UserKey, PersonalPort {
    String user();

    /** It is no longer good. */
    boolean isWithdrawn();

    /** Signs what goes there; null: nothing does. */
    @Nullable
    FrameSigner signer();

    /** What of its user's rights comes along. */
    Principal rights(Principal user);
}
