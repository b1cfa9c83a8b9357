package org.dronemap.core.conduct;

import org.dronemap.core.virtual.VirtualDrone;

/** Hears of virtual drones on the conductor's thread, once a change is durable; must return at once. */
public interface VirtualDroneListener {
    void changed(VirtualDrone drone);

    void removed(VirtualDrone drone);
}
