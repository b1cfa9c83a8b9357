package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.stored.Stored;

/** The stage of a recovery as a whole. */
@Stored(names = "STOPPING COMING_DOWN GIVING_BACK OVER")
public enum RecoveryStage {
    /** All drones stop where they are. */
    STOPPING,
    /** All come home, or down, each in its turn. */
    COMING_DOWN,
    /** It was called off: all that are not on their way down stop, and go over to whoever asked. */
    GIVING_BACK,
    OVER
}
