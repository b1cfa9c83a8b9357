package org.dronemap.cognitive.operation.run.model;

import org.dronemap.core.stored.Stored;

/** The event that a decision or a re-planning of a mission run follows from. */
@Stored(
        names = "START TAKEN_OVER LOST HEARD_AGAIN GONE CRASHED LOW_BATTERY WENT_HOME CAME_DOWN "
                + "REMOVED OFF_PATH LATE COMMAND_FAILED WAYPOINTS_ADDED WAYPOINT_MOVED "
                + "WAYPOINT_CANCELLED FENCE_ADDED JOINED RESUMED GIVEN_UP TOO_NEAR BETTER_PLAN ANSWERED "
                + "RESTARTED PAUSED WENT_ON STOPPED ENDED LINK_FALLING")
public enum RunTrigger {
    START,
    /** Somebody who goes first steers a drone. */
    TAKEN_OVER,
    LOST,
    HEARD_AGAIN,
    /** It was silent for so long that it must be down. */
    GONE,
    CRASHED,
    LOW_BATTERY,
    /** Its own fail-safe brings it home or down. */
    WENT_HOME,
    /** It came down before its end. */
    CAME_DOWN,
    REMOVED,
    OFF_PATH,
    LATE,
    COMMAND_FAILED,
    WAYPOINTS_ADDED,
    WAYPOINT_MOVED,
    WAYPOINT_CANCELLED,
    FENCE_ADDED,
    JOINED,
    RESUMED,
    GIVEN_UP,
    /** Two drones would come too near to each other. */
    TOO_NEAR,
    BETTER_PLAN,
    ANSWERED,
    RESTARTED,
    PAUSED,
    WENT_ON,
    STOPPED,
    ENDED,
    /** Its link is expected to be lost soon. */
    LINK_FALLING
}
