package org.dronemap.sim.autopilot.items;

import org.dronemap.sim.flight.SimulatedMissionItem;

/** Stores every item that the simulated vehicle can fly, as it is; the INT frames read back as the plain ones. */
public final class WholeItemStorage implements MissionItemStorage {
    private static final int MAX_LATITUDE = 900_000_000;
    private static final int MAX_LONGITUDE = 1_800_000_000;

    @Override
    public int judge(SimulatedMissionItem sent, int last) {
        if (!sent.isRunnable()) {
            return UNSUPPORTED;
        }
        return sent.isNavigation() && isOffEarth(sent) ? INVALID_PARAM5 : ACCEPTED;
    }

    private static boolean isOffEarth(SimulatedMissionItem item) {
        return Math.abs((long) item.x()) > MAX_LATITUDE || Math.abs((long) item.y()) > MAX_LONGITUDE;
    }

    @Override
    public SimulatedMissionItem keep(SimulatedMissionItem sent) {
        boolean placeless = sent.command() == SimulatedMissionItem.RETURN_TO_LAUNCH;
        return sent.with(placeless ? SimulatedMissionItem.FRAME_AMSL : plainFrame(sent.frame()), sent.z());
    }

    private static int plainFrame(int frame) {
        return frame == 6 ? 3 : frame == 5 ? 0 : frame;
    }
}
