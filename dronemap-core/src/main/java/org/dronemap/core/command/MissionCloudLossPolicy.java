package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Policy for a drone on a mission that loses the cloud: continue the mission, or return to launch. */
@Stored(names = "CONTINUE RETURN_TO_LAUNCH")
public enum MissionCloudLossPolicy {
    /** Fly the mission to its end. */
    CONTINUE,
    /** Give the mission up and return to launch. */
    RETURN_TO_LAUNCH
}
