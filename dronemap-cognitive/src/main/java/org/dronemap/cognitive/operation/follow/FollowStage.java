package org.dronemap.cognitive.operation.follow;

import org.dronemap.core.stored.Stored;

/** The stage of one drone of a follow. */
@Stored(names = "ALLOCATED STARTING TRACKING PAUSED SUSPENDED RETURNING OVER")
public enum FollowStage {
    /** A drone is kept for it, on the ground. */
    ALLOCATED,
    /** The drone takes off. */
    STARTING,
    TRACKING,
    /** The drone stays where it is, in the air. */
    PAUSED,
    /** A pilot or somebody else has the drone. */
    SUSPENDED,
    /** The drone flies home. */
    RETURNING,
    OVER;

    /** The follow needs control of its drone. */
    boolean holds() {
        return this != SUSPENDED && this != OVER;
    }
}
