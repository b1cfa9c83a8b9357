package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.stored.Stored;

/** The manner in which drones come down: at their homes, or each where it is. */
@Stored(names = "RETURN LAND")
public enum RecoveryManner {
    RETURN,
    LAND
}
