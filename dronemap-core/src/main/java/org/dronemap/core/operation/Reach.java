package org.dronemap.core.operation;

/** How whoever tells of {@link Sighting}s is reached, as its connection shows. */
public enum Reach {
    /** It said something lately, if only that it is there. */
    SPEAKS,
    /** Its connection answers, and itself it says nothing: it was put to sleep, or stands still. */
    ASLEEP,
    /** Nothing comes back any more. */
    CUT,
    /** It ended the connection. */
    GONE
}
