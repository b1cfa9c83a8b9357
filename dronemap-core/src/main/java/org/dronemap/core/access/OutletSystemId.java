package org.dronemap.core.access;

import org.dronemap.core.drone.DroneId;

/** The system id, 1 to 255, under which a user's own ground stations know a drone; no two drones of a user share one. */
public record OutletSystemId(String user, DroneId drone, int systemId) {
    public OutletSystemId {
        if (systemId < 1 || systemId > 255) {
            throw new IllegalArgumentException("a system id is 1 to 255: " + systemId);
        }
    }
}
