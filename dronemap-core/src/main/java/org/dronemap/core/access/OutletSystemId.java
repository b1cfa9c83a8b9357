package org.dronemap.core.access;

import org.dronemap.core.drone.DroneId;

/** The MAVLink system id, 1 to 255, by which one user's ground stations at the outlet see a drone; unique per user. */
public record OutletSystemId(String user, DroneId drone, int systemId) {
    public OutletSystemId {
        if (systemId < 1 || systemId > 255) {
            throw new IllegalArgumentException("a system id is 1 to 255: " + systemId);
        }
    }
}
