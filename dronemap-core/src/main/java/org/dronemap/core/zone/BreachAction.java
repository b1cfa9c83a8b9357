package org.dronemap.core.zone;

import org.dronemap.core.stored.Stored;

/** Action that is commanded when a drone breaches a zone in flight. */
@Stored(names = "HOLD RETURN_TO_LAUNCH LAND")
public enum BreachAction {
    HOLD,
    RETURN_TO_LAUNCH,
    LAND
}
