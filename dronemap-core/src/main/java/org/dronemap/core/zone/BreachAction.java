package org.dronemap.core.zone;

/** What a drone is told when it breaches a zone in flight. */
public enum BreachAction {
    HOLD,
    RETURN_TO_LAUNCH,
    LAND
}
