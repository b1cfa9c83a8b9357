package org.dronemap.core.recording;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Metadata of a recording of the messages to and from one drone, usually of one flight.
 *
 * @param droneName as it was called when the recording began
 * @param start time of the first message; some seconds before arming
 * @param end time of the last message; null while it goes on
 * @param drops messages that found no room and are missing
 * @param notice what a reader has to know, a sentence: why it is not complete; null otherwise
 */
public record Recording(
        String id,
        DroneId drone,
        String droneName,
        Instant start,
        @Nullable Instant end,
        long bytes,
        long frames,
        long drops,
        State state,
        @Nullable String notice) {

    /** State of a recording: running, complete or incomplete. */
    @Stored(names = "RUNNING COMPLETE INCOMPLETE")
    public enum State {
        RUNNING,
        COMPLETE,
        /** Something is missing; the notice says what. */
        INCOMPLETE
    }
}
