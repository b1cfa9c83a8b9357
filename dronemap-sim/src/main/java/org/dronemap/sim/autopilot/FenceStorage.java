package org.dronemap.sim.autopilot;

import java.util.List;
import org.dronemap.sim.flight.SimulatedMissionItem;

/** Keeps the items of an autopilot's fence or of its rally points; each answer is a MAV_MISSION_RESULT. */
public interface FenceStorage {
    int ACCEPTED = 0;
    int ERROR = 1;
    int UNSUPPORTED = 3;

    /** Judges an item as it arrives. */
    int judge(SimulatedMissionItem item);

    /** Takes all items in the place of the present ones, or refuses them and keeps those. */
    int store(List<SimulatedMissionItem> items);

    List<SimulatedMissionItem> items();

    /** Storage that takes everything, and heeds nothing of it. */
    static FenceStorage unheeded() {
        return new FenceStorage() {
            private List<SimulatedMissionItem> held = List.of();

            @Override
            public int judge(SimulatedMissionItem item) {
                return ACCEPTED;
            }

            @Override
            public int store(List<SimulatedMissionItem> items) {
                held = List.copyOf(items);
                return ACCEPTED;
            }

            @Override
            public List<SimulatedMissionItem> items() {
                return held;
            }
        };
    }
}
