package org.dronemap.core.conduct;

import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.virtual.VirtualDrone;

/** Makes the lease holder by which a virtual drone controls the real drone that serves it; takes no lease itself. */
final class VirtualLeaseHolders {
    private VirtualLeaseHolders() {}

    static LeaseHolder.Operation of(VirtualDrone drone) {
        return new LeaseHolder.Operation(
                drone.id().value(), drone.owner(), "The virtual drone “" + drone.name() + "” of " + drone.owner());
    }
}
