package org.dronemap.core.drone;

/** Part of a drone's state that a vehicle tells again and again; it may stop while the link lives. */
public enum StatePart {
    MODE,
    ARMED,
    READINESS,
    FLIGHT,
    POSITION,
    LOCAL,
    MOTION,
    ATTITUDE,
    BATTERY,
    GPS
}
