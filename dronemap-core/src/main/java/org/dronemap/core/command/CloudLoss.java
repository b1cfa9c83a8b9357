package org.dronemap.core.command;

/** What a vehicle on a mission does by itself when it no longer hears the cloud. */
public enum CloudLoss {
    /** Fly the mission to its end. */
    CONTINUE,
    /** Give the mission up and return to launch. */
    RETURN_TO_LAUNCH
}
