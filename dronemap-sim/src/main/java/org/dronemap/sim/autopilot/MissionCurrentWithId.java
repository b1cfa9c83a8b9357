package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.MissionCurrent;

/** MISSION_CURRENT of a simulated vehicle with the mission id, a field newer than the generated message. */
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
