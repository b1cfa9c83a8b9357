package org.dronemap.sim.autopilot;

/** The numbers of the MAV_CMDs that simulated vehicles know. */
public final class MavCmd {
    public static final int LOITER_UNLIMITED = 17;
    public static final int RETURN_TO_LAUNCH = 20;
    public static final int LAND = 21;
    public static final int TAKEOFF = 22;
    public static final int CONDITION_YAW = 115;
    public static final int SET_MODE = 176;
    public static final int CHANGE_SPEED = 178;
    public static final int SET_HOME = 179;
    public static final int SET_RELAY = 181;
    public static final int REPOSITION = 192;
    public static final int PAUSE_CONTINUE = 193;
    public static final int SET_REVERSE = 194;
    public static final int DIGICAM_CONTROL = 203;
    public static final int FENCE_ENABLE = 207;
    public static final int SET_MISSION_CURRENT = 224;
    public static final int REBOOT = 246;
    public static final int MISSION_START = 300;
    public static final int ARM_DISARM = 400;
    public static final int RUN_PREARM_CHECKS = 401;
    public static final int GET_HOME_POSITION = 410;
    public static final int GET_MESSAGE_INTERVAL = 510;
    public static final int SET_MESSAGE_INTERVAL = 511;
    public static final int REQUEST_MESSAGE = 512;
    public static final int REQUEST_CAPABILITIES = 520;
    public static final int IMAGE_START_CAPTURE = 2000;
    public static final int FORCE = 21196;

    private MavCmd() {}
}
