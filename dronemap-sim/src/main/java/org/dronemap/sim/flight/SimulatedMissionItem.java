package org.dronemap.sim.flight;

import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;

/**
 * A mission item as stored in a simulated vehicle, which must read back as it was uploaded. {@code x}, {@code y} in
 * 1e-7 degrees, {@code z} in metres.
 */
public record SimulatedMissionItem(
        int command,
        int frame,
        int autocontinue,
        float param1,
        float param2,
        float param3,
        float param4,
        int x,
        int y,
        float z) {

    public static final int WAYPOINT = 16;
    public static final int LOITER_UNLIMITED = 17;
    public static final int LOITER_TURNS = 18;
    public static final int LOITER_TIME = 19;
    public static final int RETURN_TO_LAUNCH = 20;
    public static final int LAND = 21;
    public static final int TAKEOFF = 22;
    public static final int CHANGE_ALTITUDE = 30;
    public static final int LOITER_TO_ALTITUDE = 31;
    public static final int VTOL_TAKEOFF = 84;
    public static final int VTOL_LAND = 85;
    public static final int DELAY = 93;
    public static final int CONDITION_YAW = 115;
    public static final int JUMP = 177;
    public static final int CHANGE_SPEED = 178;
    public static final int SET_SERVO = 183;
    public static final int LAND_START = 189;
    public static final int LOOK_AT = 195;
    public static final int LOOK_AHEAD = 197;
    public static final int SET_ROI = 201;
    public static final int DIGICAM_CONTROL = 203;

    public static final int FRAME_AMSL = 0;
    private static final int FRAME_AMSL_INT = 5;

    public static SimulatedMissionItem home(LocalFrame frame) {
        return new SimulatedMissionItem(
                WAYPOINT,
                FRAME_AMSL,
                1,
                0,
                0,
                0,
                0,
                (int) Math.round(frame.latitude() * 1e7),
                (int) Math.round(frame.longitude() * 1e7),
                (float) frame.altitudeAmsl());
    }

    public SimulatedMissionItem with(int otherFrame, float otherZ) {
        return new SimulatedMissionItem(
                command, otherFrame, autocontinue, param1, param2, param3, param4, x, y, otherZ);
    }

    /** True for items that are flown, false for those that only set something. */
    public boolean isNavigation() {
        return command < 95;
    }

    public boolean isRunnable() {
        return isFlown() || isCondition() || isSetting();
    }

    /** A navigation item that every simulated vehicle can fly. */
    public boolean isFlown() {
        return switch (command) {
            case WAYPOINT, LOITER_UNLIMITED, LOITER_TIME, RETURN_TO_LAUNCH, LAND, TAKEOFF, DELAY -> true;
            default -> false;
        };
    }

    private boolean isCondition() {
        return command >= 112 && command <= 115;
    }

    /** Orders to speed, servos, mounts and cameras. */
    private boolean isSetting() {
        boolean toCamera = (command >= 530 && command <= 534) || (command >= 2000 && command <= 2501);
        return (command >= 178 && command <= 252) || command == 1000 || toCamera;
    }

    public boolean hasPlace() {
        return x != 0 || y != 0;
    }

    /** Metres above the frame's origin; a relative altitude counts from there. */
    public double up(LocalFrame home) {
        return frame == FRAME_AMSL || frame == FRAME_AMSL_INT ? z - home.altitudeAmsl() : z;
    }

    public NeuPosition target(LocalFrame home, NeuPosition here) {
        return hasPlace() ? home.locate(x / 1e7, y / 1e7, up(home)) : here.withUp(up(home));
    }

    /** The word that ArduPilot has for it. */
    public String typeName() {
        return switch (command) {
            case WAYPOINT -> "WP";
            case LOITER_UNLIMITED -> "LoitUnlim";
            case LOITER_TURNS -> "LoitTurns";
            case LOITER_TIME -> "LoitTime";
            case LOITER_TO_ALTITUDE -> "LoitAltitude";
            case RETURN_TO_LAUNCH -> "RTL";
            case LAND -> "Land";
            case TAKEOFF -> "Takeoff";
            case VTOL_TAKEOFF -> "VTOLTakeoff";
            case VTOL_LAND -> "VTOLLand";
            case DELAY -> "Delay";
            case CONDITION_YAW -> "CondYaw";
            case CHANGE_SPEED -> "ChangeSpeed";
            case SET_SERVO -> "SetServo";
            case LAND_START -> "LandStart";
            case LOOK_AT, LOOK_AHEAD, SET_ROI -> "SetROI";
            case JUMP -> "Jump";
            case CHANGE_ALTITUDE -> "ContinueAndChangeAlt";
            case DIGICAM_CONTROL -> "DigiCamCtrl";
            default -> "Cmd" + command;
        };
    }
}
