package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.MissionCurrent;

/** MISSION_CURRENT with the number of the mission, a field younger than the definitions that messages are made from. */
record MissionCurrentWithId(MissionCurrent plain, long missionStamp) implements Message {
    @Override
    public int messageId() {
        return MissionCurrent.ID;
    }

    @Override
    public void write(PayloadWriter out) {
        plain.write(out);
        out.u32(missionStamp);
    }
}
