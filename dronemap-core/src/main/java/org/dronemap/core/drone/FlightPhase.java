package org.dronemap.core.drone;

/** Where the vehicle is between ground and air, as it says itself. */
public enum FlightPhase {
    ON_GROUND,
    TAKING_OFF,
    IN_AIR,
    LANDING
}
