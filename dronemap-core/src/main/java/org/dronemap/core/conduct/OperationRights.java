package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.drone.DroneId;

/** Whom operations may command drones for, as things are whenever it is asked. Any thread. */
@FunctionalInterface
public interface OperationRights {
    /** Why drones cannot be commanded for that user any more, as a sentence; empty: they can. */
    Optional<String> whyNot(String owner, DroneId drone);
}
