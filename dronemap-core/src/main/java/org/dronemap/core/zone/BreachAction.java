package org.dronemap.core.zone;

import org.dronemap.core.stored.Stored;

/** What a drone is told when it breaches a zone in flight. */
@Stored(names = "HOLD RETURN_TO_LAUNCH LAND")
public enum BreachAction {
    HOLD,
    RETURN_TO_LAUNCH,
    LAND
}
