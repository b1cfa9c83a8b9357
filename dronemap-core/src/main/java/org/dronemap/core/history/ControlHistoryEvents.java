package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseHolder;

/** Makes the history events of changes of control of a drone. */
final class ControlHistoryEvents {
    private ControlHistoryEvents() {}

    static HistoryEvent of(DroneId drone, Instant at, ControlChange change) {
        LeaseHolder other = change.other();
        return new HistoryEvent(
                drone,
                at,
                HistoryEvent.Kind.CONTROL,
                change.by().words() + " " + verb(change.kind()) + (other == null ? "." : " (" + other.words() + ")."),
                null,
                change.by().userName().orElse(null),
                null,
                null,
                change.reason());
    }

    private static String verb(ControlChange.Kind kind) {
        return switch (kind) {
            case TAKEN -> "took control";
            case REQUESTED -> "asked for control";
            case REFUSED -> "refused control";
            case HANDED_OVER -> "handed control over";
            case TAKEN_OVER -> "took control over";
            case RELEASED -> "gave control back";
            case EXPIRED -> "was idle, and control ended";
            case LOST -> "fell silent in control";
            case RETURN_DUE -> "was not replaced, and the drone is called back";
            case PILOT_ACTED -> "acted";
            case PILOT_LEFT -> "let go";
            case EXPELLED -> "may command no more";
        };
    }
}
