package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * An event in a drone's history, such as a command, a change of mode or control, or a message.
 *
 * @param text what people read: the vehicle's own sentence, the summary of a command, the name of a mode
 * @param severity of a message; null: it is none
 * @param by the user who did it, or whom a message names; null: nobody here
 * @param command the id of a command; null: it is none
 * @param result how that command ended, such as {@code succeeded} or {@code refused}
 * @param reason why it ended so, as a sentence; null when there is nothing to say
 */
public record HistoryEvent(
        DroneId drone,
        Instant at,
        Kind kind,
        String text,
        @Nullable Severity severity,
        @Nullable String by,
        @Nullable String command,
        @Nullable String result,
        @Nullable String reason) {

    /** Kinds of events in a drone's history. */
    @Stored(names = "ARMED DISARMED MODE PHASE MESSAGE COMMAND MISSION CONTROL")
    public enum Kind {
        ARMED,
        DISARMED,
        MODE,
        /** Between ground and air. */
        PHASE,
        /** Said by the vehicle, or by the cloud about it: alarms are among them by their severity. */
        MESSAGE,
        COMMAND,
        MISSION,
        CONTROL
    }

    /** Something that says no more than its text. */
    public static HistoryEvent of(DroneId drone, Instant at, Kind kind, String text) {
        return new HistoryEvent(drone, at, kind, text, null, null, null, null, null);
    }
}
