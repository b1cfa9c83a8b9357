package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.stored.Stored;

/** The outcome of a recovery for one of its drones. */
@Stored(names = "DOWN NOT_KNOWN TAKEN FAILED GIVEN_BACK")
public enum RecoveryOutcome {
    /** It is on the ground with its motors off. */
    DOWN,
    /** It was not heard for so long that it must be down; where, nobody knows. */
    NOT_KNOWN,
    /** Somebody else has control of it. */
    TAKEN,
    FAILED,
    /** It holds in the air, and whoever asked has control. */
    GIVEN_BACK
}
