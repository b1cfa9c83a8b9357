package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** State of a drone's link by its silence: live, suspect or lost; or ended for a replay. */
@Stored(names = "LIVE SUSPECT LOST ENDED")
public enum LinkState {
    /** Heard within its link's normal silence. */
    LIVE,
    /** Silent for longer than normal; being probed. */
    SUSPECT,
    /** Silent for the declared time; may still be flying. */
    LOST,
    /** The recording that it comes from has been played to its end. */
    ENDED
}
