package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Kind of vehicle. */
@Stored(names = "MULTICOPTER HELICOPTER FIXED_WING VTOL ROVER BOAT SUBMARINE AIRSHIP UNKNOWN")
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
