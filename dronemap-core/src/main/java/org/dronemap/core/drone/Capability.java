package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** What a vehicle may be able to do; each command and each setpoint needs exactly one of these. */
@Stored(
        names = "ARM DISARM SET_MODE TAKE_OFF LAND RETURN_TO_LAUNCH HOLD GO_TO UPLOAD_MISSION "
                + "START_MISSION PAUSE_MISSION CLEAR_MISSION TURN TAKE_PICTURE SET_RELAY READ_PARAMETERS "
                + "SET_PARAMETERS READ_LOGS FENCE RALLY_POINTS SET_HOME READ_HOME GO_TO_LOCAL "
                + "EMERGENCY_STOP READ_MAP VELOCITY STICKS TRACK")
public enum Capability {
    ARM("arm"),
    DISARM("disarm"),
    SET_MODE("change its mode"),
    TAKE_OFF("take off"),
    LAND("land"),
    RETURN_TO_LAUNCH("return to launch"),
    HOLD("hold its position"),
    GO_TO("go to a point"),
    UPLOAD_MISSION("take a mission"),
    START_MISSION("start a mission"),
    PAUSE_MISSION("pause a mission"),
    CLEAR_MISSION("clear its mission"),
    TURN("turn on the spot"),
    TAKE_PICTURE("take a picture"),
    SET_RELAY("switch a relay"),
    READ_PARAMETERS("tell its parameters"),
    SET_PARAMETERS("change its parameters"),
    READ_LOGS("tell its logs"),
    FENCE("keep a fence"),
    RALLY_POINTS("keep rally points"),
    SET_HOME("set its home"),
    READ_HOME("tell its home"),
    GO_TO_LOCAL("go to a place on its own map"),
    EMERGENCY_STOP("stop at once"),
    READ_MAP("tell its map"),
    VELOCITY("be steered by speeds"),
    STICKS("be steered by sticks"),
    TRACK("be led by a place that moves");

    private final String phrase;

    Capability(String phrase) {
        this.phrase = phrase;
    }

    /** Completes the sentence "this vehicle cannot …". */
    public String phrase() {
        return phrase;
    }
}
