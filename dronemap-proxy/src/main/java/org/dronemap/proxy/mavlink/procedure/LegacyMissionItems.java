package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;

/**
 * Converts between MAVLink's old MISSION_ITEM (degrees as floats) and MISSION_ITEM_INT (1e-7 degrees). What is no
 * place, since its frame is none of the globe's or its command has numbers there, stays the number that it is.
 */
public final class LegacyMissionItems {
    private static final double E7 = 1e7;
    private static final int FRAME_LOCAL_NED = 1;
    private static final int FRAME_MISSION = 2;
    private static final int DO_DIGICAM_CONFIGURE = 202;
    private static final int DO_DIGICAM_CONTROL = 203;

    private LegacyMissionItems() {}

    /** As vehicles and clients that know only floats send it. */
    public static MissionItemInt exact(MissionItem item) {
        double scale = scale(item.frame(), item.command());
        return new MissionItemInt(
                item.targetSystem(),
                item.targetComponent(),
                item.seq(),
                item.frame(),
                item.command(),
                item.current(),
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                (int) Math.round(item.x() * scale),
                (int) Math.round(item.y() * scale),
                item.z(),
                item.missionType());
    }

    /** As those hear it: exact to a metre or so, since a float has no more digits. */
    public static MissionItem older(MissionItemInt item) {
        double scale = scale(item.frame(), item.command());
        return new MissionItem(
                item.targetSystem(),
                item.targetComponent(),
                item.seq(),
                item.frame(),
                item.command(),
                item.current(),
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                (float) (item.x() / scale),
                (float) (item.y() / scale),
                item.z(),
                item.missionType());
    }

    private static double scale(int frame, int command) {
        boolean place = frame != FRAME_LOCAL_NED
                && frame != FRAME_MISSION
                && command != DO_DIGICAM_CONFIGURE
                && command != DO_DIGICAM_CONTROL;
        return place ? E7 : 1;
    }
}
