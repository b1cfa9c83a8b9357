package org.dronemap.core.command;

import org.dronemap.core.drone.Capability;

/** Which commands compete with each other on one vehicle. */
public enum Contention {
    /** Motors on or off; the newer one wins. */
    ARMING,
    /** Where to fly; the newer one wins. */
    FLIGHT,
    /** Mission items on the wire; the first one goes on. */
    TRANSFER,
    /** The camera; the first one goes on. */
    CAMERA,
    /** The relays; the first one goes on. */
    RELAY,
    /** Parameters on the wire; the first one goes on. */
    PARAMETERS,
    /** Logs on the wire; the first one goes on. */
    LOGS,
    /** Where home is; the first one goes on. */
    HOME,
    /** The map on the wire; the first one goes on. */
    MAP;

    /** A newer command takes the place of one that is under way; else it has to wait. */
    public boolean newerWins() {
        return this == ARMING || this == FLIGHT;
    }

    static Contention of(Capability needed) {
        return switch (needed) {
            case ARM, DISARM -> ARMING;
            case UPLOAD_MISSION, CLEAR_MISSION, FENCE, RALLY_POINTS -> TRANSFER;
            case TAKE_PICTURE -> CAMERA;
            case SET_RELAY -> RELAY;
            case READ_PARAMETERS, SET_PARAMETERS -> PARAMETERS;
            case READ_LOGS -> LOGS;
            case SET_HOME, READ_HOME -> HOME;
            case READ_MAP -> MAP;
            default -> FLIGHT;
        };
    }
}
