package org.dronemap.core.conduct;

import org.dronemap.core.lease.Holder;
import org.dronemap.core.virtual.VirtualDrone;

/** A virtual drone as the holder of the drone that serves it. */
final class VirtualHolder {
    private VirtualHolder() {}

    static Holder.Operation of(VirtualDrone drone) {
        return new Holder.Operation(
                drone.id().value(), drone.owner(), "The virtual drone “" + drone.name() + "” of " + drone.owner());
    }
}
