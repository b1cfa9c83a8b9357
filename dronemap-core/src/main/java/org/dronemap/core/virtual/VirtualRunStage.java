package org.dronemap.core.virtual;

import org.dronemap.core.stored.Stored;

/** Stage of a virtual drone's run, such as queued, uploading, flying or returning. */
@Stored(
        names = "QUEUED UPLOADING ARMING STARTING FLYING RETURNING GIVING_UP STOPPING SUSPENDED DONE "
                + "FAILED STOPPED")
public enum VirtualRunStage {
    /** Waits for a drone. */
    QUEUED,
    /** Bound: the drone gets its mission. */
    UPLOADING,
    ARMING,
    STARTING,
    FLYING,
    /** All waypoints are behind it; it comes home or down. */
    RETURNING,
    /** The drone cannot go on: it is brought home, then another one is looked for. */
    GIVING_UP,
    /** The user wants it to end: the drone is brought home. */
    STOPPING,
    /** Somebody who goes first has taken the drone; waits for the user's word. */
    SUSPENDED,
    DONE,
    FAILED,
    STOPPED;

    /** A drone serves it. */
    public boolean isBound() {
        return compareTo(UPLOADING) >= 0 && compareTo(STOPPING) <= 0;
    }

    /** Nothing happens any more. */
    public boolean isOver() {
        return compareTo(DONE) >= 0;
    }
}
