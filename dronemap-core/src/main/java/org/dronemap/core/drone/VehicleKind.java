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
    UNKNOWN;

    /** It stands in the air at one place, and flies home straight at one height. */
    public boolean isRotorcraft() {
        return this == MULTICOPTER || this == HELICOPTER;
    }

    /** It drives, floats or dives: at whatever height it is, it is not in the air. */
    public boolean neverFlies() {
        return switch (this) {
            case ROVER, BOAT, SUBMARINE -> true;
            case MULTICOPTER, HELICOPTER, FIXED_WING, VTOL, AIRSHIP, UNKNOWN -> false;
        };
    }

    /** It can stand in the air, or may be one that can. */
    public boolean hovers() {
        return switch (this) {
            case MULTICOPTER, HELICOPTER, VTOL, UNKNOWN -> true;
            case FIXED_WING, AIRSHIP, ROVER, BOAT, SUBMARINE -> false;
        };
    }
}
