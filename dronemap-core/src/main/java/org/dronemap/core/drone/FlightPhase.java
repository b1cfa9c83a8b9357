package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Phase of flight between ground and air, as the vehicle reports it. */
@Stored(names = "ON_GROUND TAKING_OFF IN_AIR LANDING")
public enum FlightPhase {
    ON_GROUND,
    TAKING_OFF,
    IN_AIR,
    LANDING
}
