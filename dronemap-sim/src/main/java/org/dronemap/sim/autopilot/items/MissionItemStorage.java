package org.dronemap.sim.autopilot.items;

import org.dronemap.sim.flight.SimulatedMissionItem;

/** Decides whether an autopilot stores a mission item that it was sent, and what is left of it when it is read back. */
public interface MissionItemStorage {
    int ACCEPTED = 0;
    int ERROR = 1;
    int UNSUPPORTED_FRAME = 2;
    int UNSUPPORTED = 3;
    int INVALID_PARAM1 = 6;
    int INVALID_PARAM5 = 10;
    int INVALID_PARAM6 = 11;
    int INVALID_PARAM7 = 12;

    /** MAV_MISSION_RESULT for an item of a mission that ends with item {@code last}. */
    int judge(SimulatedMissionItem sent, int last);

    /** What is kept of an item that {@link #judge} accepted. */
    SimulatedMissionItem keep(SimulatedMissionItem sent);
}
