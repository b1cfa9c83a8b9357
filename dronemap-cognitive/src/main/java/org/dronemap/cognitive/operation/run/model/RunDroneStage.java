package org.dronemap.cognitive.operation.run.model;

import org.dronemap.core.stored.Stored;

/** The stage of one drone of a mission run. */
@Stored(
        names = "LANDED UPLOADING READY ARMING STARTING FLYING HOLDING REPLACING CONTINUING RESUMING "
                + "RETURNING SILENT SUSPENDED CRASHED GONE LEFT")
public enum RunDroneStage {
    /** On the ground, with nothing to do, or nothing to do any more. */
    LANDED,
    /** Its mission is brought to it on the ground. */
    UPLOADING,
    /** It has its mission and waits for the others, or for its time. */
    READY,
    ARMING,
    STARTING,
    FLYING,
    /** Waits in the air: for its new mission, or until another drone has passed. */
    HOLDING,
    /** Its new mission is brought to it in the air. */
    REPLACING,
    CONTINUING,
    /** Somebody gave it back: it is made to wait. */
    RESUMING,
    /** Called home, or on its own way home or down. */
    RETURNING,
    /** Not heard; it may still fly. */
    SILENT,
    /** Somebody who goes first has it; waits for a resume. */
    SUSPENDED,
    CRASHED,
    /** Not heard for so long that it is down somewhere. */
    GONE,
    /** Taken out of the run: given up, removed, or down and not to be trusted before somebody says so. */
    LEFT;

    /** New orders can be given to it. */
    public boolean acceptsCommands() {
        return compareTo(CONTINUING) <= 0;
    }

    /** It is in the air, or may be. */
    public boolean mayFly() {
        return compareTo(STARTING) >= 0 && compareTo(SUSPENDED) <= 0;
    }

    /** The run has done with it unless somebody wants otherwise. */
    public boolean isAtRest() {
        return this == LANDED || compareTo(SUSPENDED) >= 0;
    }
}
