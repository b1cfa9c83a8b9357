package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** What a vehicle on a mission does by itself when it no longer hears the cloud. */
@Stored(names = "CONTINUE RETURN_TO_LAUNCH")
public enum CloudLoss {
    /** Fly the mission to its end. */
    CONTINUE,
    /** Give the mission up and return to launch. */
    RETURN_TO_LAUNCH
}
