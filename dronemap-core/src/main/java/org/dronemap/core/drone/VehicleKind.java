package org.dronemap.core.drone;

/** What sort of machine it is. */
public enum VehicleKind {
    MULTICOPTER,
    HELICOPTER,
    FIXED_WING,
    VTOL,
    ROVER,
    BOAT,
    SUBMARINE,
    AIRSHIP,
    UNKNOWN
}
