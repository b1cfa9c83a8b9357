package org.dronemap.core.operation;

import org.dronemap.core.stored.Stored;

/** Connection state of the phone that reports the followed target's position. */
@Stored(names = "SPEAKS VAGUE ASLEEP CUT GONE")
public enum ReporterState {
    /** It said something lately, if only that it is there. */
    SPEAKS,
    /** It tells of sightings, but of none that is of use. */
    VAGUE,
    /** Its connection answers, and itself it says nothing: it was put to sleep, or stands still. */
    ASLEEP,
    /** Nothing comes back any more. */
    CUT,
    /** It ended the connection. */
    GONE
}
