package org.dronemap.proxy.outlet.rights;

import java.util.Optional;
import org.dronemap.core.access.Principal;

/**
 * Looks up the current rights of a user whose ground stations attach to the outlet. Any thread; may wait for the store.
 */
@FunctionalInterface
public interface OutletRights {
    /** Empty for a user who is gone or may do nothing any more. */
    Optional<Principal> principal(String user);
}
