package org.dronemap.proxy.session;

import org.dronemap.proxy.mavlink.procedure.MissionOpaqueId;

/**
 * Compares MAVLink's opaque mission id of a vehicle with that of the mission last read, to notice changes. Owned by the
 * drone's lane.
 */
final class MissionIdTracker {
    private long ofMissionRead = MissionOpaqueId.NONE;
    private boolean given;

    /** The vehicle numbers its missions: a change cannot go unnoticed. */
    boolean given() {
        return given;
    }

    /** The mission was read, and had that number; with {@link MissionOpaqueId#NONE} the next one heard is taken for it. */
    void read(long stamp) {
        ofMissionRead = stamp;
        given |= stamp != MissionOpaqueId.NONE;
    }

    /** True when this number is not that of the mission that was read. */
    boolean isChangedBy(long stamp) {
        if (stamp == MissionOpaqueId.NONE) {
            return false;
        }
        given = true;
        if (ofMissionRead == MissionOpaqueId.NONE) {
            ofMissionRead = stamp;
            return false;
        }
        return stamp != ofMissionRead;
    }
}
