package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Phase of a command: sent, accepted or done. */
@Stored(names = "SENT ACCEPTED DONE")
public enum CommandPhase {
    /** On its way to the vehicle. */
    SENT,
    /** The vehicle took it and is at it. */
    ACCEPTED,
    /** It has its outcome. */
    DONE
}
