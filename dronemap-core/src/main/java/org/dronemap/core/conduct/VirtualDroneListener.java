package org.dronemap.core.conduct;

import org.dronemap.core.virtual.VirtualDrone;

/** Is told of each change of a virtual drone once it is durable; must return at once. */
public interface VirtualDroneListener {
    void changed(VirtualDrone drone);

    void removed(VirtualDrone drone);
}
