package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Kind of vehicle, such as multicopter, fixed wing or rover. */
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
