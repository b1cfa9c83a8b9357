package org.dronemap.ws.operation;

import java.util.Set;
import org.dronemap.core.drone.DroneId;

/** The pool: drones that may be armed with nobody beside them, as they are whenever it is asked. Any thread. */
@FunctionalInterface
public interface DronePool {
    Set<DroneId> drones();
}
