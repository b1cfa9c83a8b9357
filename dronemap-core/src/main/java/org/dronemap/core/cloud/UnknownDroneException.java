package org.dronemap.core.cloud;

import org.dronemap.core.drone.DroneId;

/** A caller named a drone that is not there. */
public final class UnknownDroneException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public UnknownDroneException(DroneId id) {
        super("There is no drone " + id + ".");
    }
}
