package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneId;

/** Thrown when a caller names a drone that does not exist. */
public final class UnknownDroneException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public UnknownDroneException(DroneId id) {
        super("There is no drone " + id + ".");
    }
}
