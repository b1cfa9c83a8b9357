package org.dronemap.proxy.outlet.rights;

import org.dronemap.core.access.Principal;
import org.jspecify.annotations.Nullable;

/** Acts by the rights of a user, which {@link OutletRightsWatch} sets anew while it is attached. Any thread. */
public interface RightsHolder {
    /** The user whose rights it acts by. */
    String user();

    /** Sets what its user may do from now on; null: nothing any more. */
    void setRights(@Nullable Principal now);
}
