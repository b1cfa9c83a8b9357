package org.dronemap.proxy.session;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.VehicleType;

/**
 * Chooses which of the components of one vehicle is its autopilot. Programs on companion computers, cameras and gimbals
 * may call themselves a vehicle too: the autopilot is it as soon as it is heard, and stays it while it is silent. Owned
 * by the thread that brings the frames.
 */
final class AutopilotChoice {
    /** MAV_COMP_ID_AUTOPILOT1. */
    private static final int AUTOPILOT = 1;
    /** From here on component ids are of users' own devices, cameras, gimbals, computers and the like. */
    private static final int FIRST_DEVICE = 25;

    private static final int LIKELY = 1;
    /** A vehicle may have been given other firmware; a single heartbeat may be anybody's. */
    private static final int BEATS_OF_ANOTHER = 3;

    private int component = -1;
    private int autopilot;
    private int type;
    private int best;
    private int beatsOfAnother;

    /** A session of this component may begin: it is no device of a vehicle whose autopilot was heard here before. */
    boolean admits(Frame frame) {
        return rank(frame.componentId()) >= Math.min(best, LIKELY);
    }

    /** From now on the vehicle is spoken to as the sender of this heartbeat. */
    void chosen(Frame frame) {
        Heartbeat heartbeat = VehicleType.announced(frame).orElseThrow();
        component = frame.componentId();
        autopilot = heartbeat.autopilot();
        type = heartbeat.type();
        best = Math.max(best, rank(component));
        beatsOfAnother = 0;
    }

    /** True for a frame that shows a better choice than the one made, or that the chosen one has become another. */
    boolean isContradictedBy(Frame frame) {
        Heartbeat heartbeat =
                component < 0 ? null : VehicleType.announced(frame).orElse(null);
        if (heartbeat == null) {
            return false;
        }
        if (frame.componentId() != component) {
            return rank(frame.componentId()) > rank(component);
        }
        boolean same = heartbeat.autopilot() == autopilot && heartbeat.type() == type;
        beatsOfAnother = same ? 0 : beatsOfAnother + 1;
        return beatsOfAnother >= BEATS_OF_ANOTHER;
    }

    private static int rank(int component) {
        return component == AUTOPILOT ? LIKELY + 1 : component < FIRST_DEVICE ? LIKELY : 0;
    }
}
