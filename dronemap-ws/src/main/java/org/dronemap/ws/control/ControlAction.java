package org.dronemap.ws.control;

/** Actions on the control of a drone. */
public enum ControlAction {
    TAKE,
    REQUEST,
    GRANT,
    REFUSE,
    HAND_OVER,
    TAKE_OVER,
    HEARTBEAT,
    RELEASE
}
