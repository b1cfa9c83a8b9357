package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Where the vehicle is between ground and air, as it says itself. */
@Stored(names = "ON_GROUND TAKING_OFF IN_AIR LANDING")
public enum FlightPhase {
    ON_GROUND,
    TAKING_OFF,
    IN_AIR,
    LANDING
}
