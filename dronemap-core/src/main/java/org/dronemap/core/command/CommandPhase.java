package org.dronemap.core.command;

/** How far a command is. */
public enum CommandPhase {
    /** On its way to the vehicle. */
    SENT,
    /** The vehicle took it and is at it. */
    ACCEPTED,
    /** It has its outcome. */
    DONE
}
