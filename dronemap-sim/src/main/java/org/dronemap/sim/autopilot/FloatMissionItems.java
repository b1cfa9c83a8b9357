package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;

/** Converts the old MISSION_ITEM (degrees as floats) for a simulated vehicle whose client still uses it. */
final class FloatMissionItems {
    private FloatMissionItems() {}

    static MissionItem of(MissionItemInt item) {
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
                item.x() / 1e7f,
                item.y() / 1e7f,
                item.z(),
                item.missionType());
    }

    static MissionItemInt toInt(MissionItem item) {
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
                (int) Math.round(item.x() * 1e7),
                (int) Math.round(item.y() * 1e7),
                item.z(),
                item.missionType());
    }
}
