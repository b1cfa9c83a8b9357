package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.access.Principal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseStep;

/**
 * Lets the users of ground stations at the outlet take or release control of drones, and audits it. Any thread; may
 * wait for the store.
 */
@FunctionalInterface
public interface OutletLeaseAuthority {
    /**
     * Whether this user may is asked before.
     *
     * @throws org.dronemap.core.cloud.UnknownDroneException when there is no such drone (any more)
     */
    LeaseStep act(Principal by, DroneId drone, LeaseEvent event);
}
