package org.dronemap.proxy.mavlink.procedure;

/** What may happen to one message on its way. */
enum MessageFault {
    LOST,
    /** Longer than anybody waits before asking again. */
    LATE,
    DOUBLED,
    /** Those sent after it come first. */
    OVERTAKEN
}
