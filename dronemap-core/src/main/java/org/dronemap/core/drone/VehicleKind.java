package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** What sort of machine it is. */
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
