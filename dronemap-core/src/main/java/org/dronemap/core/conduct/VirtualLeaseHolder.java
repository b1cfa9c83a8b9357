package org.dronemap.core.conduct;

import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.virtual.VirtualDrone;

/** A virtual drone as the holder of the drone that serves it. */
final class VirtualLeaseHolder {
    private VirtualLeaseHolder() {}

    static LeaseHolder.Operation of(VirtualDrone drone) {
        return new LeaseHolder.Operation(
                drone.id().value(), drone.owner(), "The virtual drone “" + drone.name() + "” of " + drone.owner());
    }
}
