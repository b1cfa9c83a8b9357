package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Behaviour of a vehicle on a mission when it loses the cloud. */
@Stored(names = "CONTINUE RETURN_TO_LAUNCH")
public enum MissionCloudLossPolicy {
    /** Fly the mission to its end. */
    CONTINUE,
    /** Give the mission up and return to launch. */
    RETURN_TO_LAUNCH
}
