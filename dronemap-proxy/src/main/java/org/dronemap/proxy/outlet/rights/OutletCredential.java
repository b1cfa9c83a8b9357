package org.dronemap.proxy.outlet.rights;

import org.dronemap.core.access.Principal;
import org.dronemap.mavlink.FrameSigner;
import org.jspecify.annotations.Nullable;

/** Credential that a ground station was admitted to the outlet by: its user's key, or a personal port. Any thread. */
public interface OutletCredential {
    String user();

    /** It is no longer good. */
    boolean isWithdrawn();

    /** Signs what goes there; null: nothing does. */
    @Nullable
    FrameSigner signer();

    /** True when nothing is ever changed by it, whatever its user may do. */
    boolean onlyLooks();

    /** What of its user's rights comes along. */
    Principal rights(Principal user);
}
