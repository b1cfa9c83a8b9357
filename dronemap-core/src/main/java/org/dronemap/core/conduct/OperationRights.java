package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.SavedOperation;

/** Tells whether an operation may still command a drone on behalf of its user; evaluated at each call. Any thread. */
@FunctionalInterface
public interface OperationRights {
    /** Why that drone cannot be commanded for whom it is conducted any more, as a sentence; empty: it can. */
    Optional<String> whyNot(SavedOperation operation, DroneId drone);
}
