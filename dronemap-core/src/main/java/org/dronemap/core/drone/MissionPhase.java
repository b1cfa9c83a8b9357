package org.dronemap.core.drone;

/** Phase of the mission as the vehicle reports it (MAVLink: MISSION_STATE). */
public enum MissionPhase {
    /** It holds a mission and does not fly it: not begun yet, or left for another mode. */
    STOPPED,
    RUNNING,
    PAUSED,
    /** It flew to the end; some vehicles then head for the first item again without flying there. */
    COMPLETE
}
