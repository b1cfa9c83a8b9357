package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;

/** Reads MAVLink's opaque mission id, a number that some vehicles change whenever their mission changes. */
public final class MissionOpaqueId {
    /** The vehicle gives none. */
    public static final long NONE = 0;

    private static final int AFTER_MISSION_CURRENT = 6;
    private static final int AFTER_MISSION_COUNT = 5;
    private static final int AFTER_MISSION_ACK = 4;

    private MissionOpaqueId() {}

    /** What this frame says about the mission (not fence or rally points); {@link #NONE} when it says nothing. */
    public static long of(Frame frame) {
        return switch (frame.messageId()) {
            case MissionCurrent.ID -> frame.u32(AFTER_MISSION_CURRENT);
            case MissionCount.ID ->
                MissionCount.decode(frame).missionType() == 0 ? frame.u32(AFTER_MISSION_COUNT) : NONE;
            case MissionAck.ID -> accepted(MissionAck.decode(frame)) ? frame.u32(AFTER_MISSION_ACK) : NONE;
            default -> NONE;
        };
    }

    private static boolean accepted(MissionAck ack) {
        return ack.type() == MavMissionResult.ACCEPTED && ack.missionType() == 0;
    }
}
