package org.dronemap.core.history;

import java.time.Instant;

/** An entry in the numbered series of all drones' events: an event, or a gap where events are missing. */
public sealed interface EventEntry permits NumberedEvent, EventGap {
    /** Rises from entry to entry within a series, with numbers left out; 1 to 2^53. */
    long number();

    /** When it happened, or what is missing had ended. */
    Instant at();
}
