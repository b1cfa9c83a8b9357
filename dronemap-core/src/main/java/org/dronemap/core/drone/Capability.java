package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Something that a vehicle may be able to do; each command and each setpoint needs exactly one. */
@Stored(
        names = "ARM DISARM SET_MODE TAKE_OFF LAND RETURN_TO_LAUNCH HOLD GO_TO UPLOAD_MISSION "
                + "START_MISSION PAUSE_MISSION CLEAR_MISSION TURN TAKE_PICTURE SET_RELAY READ_PARAMETERS "
                + "SET_PARAMETERS READ_LOGS FENCE RALLY_POINTS SET_HOME READ_HOME GO_TO_LOCAL "
                + "EMERGENCY_STOP READ_MAP VELOCITY STICKS TRACK CHANGE_SPEED")
public enum Capability {
    ARM("arm", Readiness.DISARMED, Part.OPERATES),
    DISARM("disarm", Readiness.ARMED_ON_THE_GROUND, Part.OPERATES),
    SET_MODE("change its mode", Readiness.ANY, Part.OPERATES),
    TAKE_OFF("take off", Readiness.READY_TO_TAKE_OFF, Part.OPERATES),
    LAND("land", Readiness.ARMED, Part.OPERATES),
    RETURN_TO_LAUNCH("return to launch", Readiness.ARMED, Part.OPERATES),
    HOLD("hold its position", Readiness.ARMED, Part.OPERATES),
    GO_TO("go to a point", Readiness.UNDER_WAY, Part.OPERATES),
    UPLOAD_MISSION("take a mission", Readiness.ANY, Part.PREPARES),
    START_MISSION("start a mission", Readiness.WITH_MISSION, Part.OPERATES),
    PAUSE_MISSION("pause a mission", Readiness.ARMED, Part.OPERATES),
    CLEAR_MISSION("clear its mission", Readiness.ANY, Part.PREPARES),
    TURN("turn on the spot", Readiness.UNDER_WAY, Part.OPERATES),
    TAKE_PICTURE("take a picture", Readiness.ANY, Part.OPERATES),
    SET_RELAY("switch a relay", Readiness.ANY, Part.OPERATES),
    READ_PARAMETERS("tell its parameters", Readiness.ANY, Part.OPERATES),
    SET_PARAMETERS("change its parameters", Readiness.ANY, Part.OPERATES),
    READ_LOGS("tell its logs", Readiness.ANY, Part.OPERATES),
    FENCE("keep a fence", Readiness.ANY, Part.PREPARES),
    RALLY_POINTS("keep rally points", Readiness.ANY, Part.PREPARES),
    SET_HOME("set its home", Readiness.ANY, Part.OPERATES),
    READ_HOME("tell its home", Readiness.ANY, Part.OPERATES),
    GO_TO_LOCAL("go to a place on its own map", Readiness.UNDER_WAY, Part.OPERATES),
    EMERGENCY_STOP("stop at once", Readiness.ANY, Part.OPERATES),
    READ_MAP("tell its map", Readiness.ANY, Part.OPERATES),
    VELOCITY("be steered by speeds", Readiness.UNDER_WAY, Part.OPERATES),
    STICKS("be steered by sticks", Readiness.ARMED_BEFORE, Part.OPERATES),
    TRACK("be led by a place that moves", Readiness.UNDER_WAY, Part.OPERATES),
    CHANGE_SPEED("change its speed", Readiness.UNDER_WAY, Part.OPERATES);

    /** State that a drone must be in for an action. What has no motors to arm is always armed. */
    public enum Readiness {
        /** It may be as it is. */
        ANY,
        DISARMED,
        ARMED_ON_THE_GROUND,
        /** Armed, and on the ground: whoever asks for it in the air is told that it is there already. */
        READY_TO_TAKE_OFF,
        ARMED,
        /** Armed; whoever asks for it too early is told to arm first. */
        ARMED_BEFORE,
        /** Armed, and in the air where it flies. */
        UNDER_WAY,
        /** Armed, and with a mission on board. */
        WITH_MISSION
    }

    /** Part of an action in a flight (preparation or operation), which decides which user roles may request it. */
    public enum Part {
        /** It prepares a flight and moves nothing: planners may, while the drone is disarmed. */
        PREPARES,
        /** It is for operators. */
        OPERATES
    }

    private final String phrase;
    private final Readiness readiness;
    private final Part part;

    Capability(String phrase, Readiness readiness, Part part) {
        this.phrase = phrase;
        this.readiness = readiness;
        this.part = part;
    }

    /** Completes the sentence "this vehicle cannot …". */
    public String phrase() {
        return phrase;
    }

    public Readiness readiness() {
        return readiness;
    }

    public Part part() {
        return part;
    }
}
