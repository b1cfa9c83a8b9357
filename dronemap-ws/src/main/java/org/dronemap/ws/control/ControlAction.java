package org.dronemap.ws.control;

/** Action of a user on the control of a drone: take, request, grant, refuse, hand over, take over, keep, release. */
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
