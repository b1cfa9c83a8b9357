package org.dronemap.core.command;

/** Classes of commands that cannot be under way on one vehicle at the same time, such as two mission transfers. */
public enum Contention {
    /** Motors on or off; the newer one wins. */
    ARMING,
    /** Where to fly; the newer one wins. */
    FLIGHT,
    /** How fast; the newer one wins, and where it flies stays as it is. */
    SPEED,
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
        return this == ARMING || this == FLIGHT || this == SPEED;
    }
}
