package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseHolder;

/** Makes the history events of changes of control of a drone. */
final class ControlHistoryEvents {
    private ControlHistoryEvents() {}

    static HistoryEvent of(DroneId drone, Instant at, ControlChange change) {
        return new HistoryEvent(
                drone,
                at,
                HistoryEvent.Kind.CONTROL,
                sentence(change),
                null,
                change.by().userName().orElse(null),
                null,
                null,
                change.reason());
    }

    private static String sentence(ControlChange change) {
        String by = change.by().words();
        LeaseHolder other = change.other();
        String whom = other == null ? "" : other.words();
        return switch (change.kind()) {
            case TAKEN -> by + " took control.";
            case REQUESTED -> other == null ? by + " asked for control." : by + " asked " + whom + " for control.";
            case REFUSED ->
                other == null ? by + " kept control." : by + " kept control, which " + whom + " had asked for.";
            case HANDED_OVER -> by + " handed control over" + (other == null ? "." : " to " + whom + ".");
            case TAKEN_OVER -> by + " took control over" + (other == null ? "." : " from " + whom + ".");
            case RELEASED -> by + " gave control back.";
            case EXPIRED -> by + " was idle, and control ended.";
            case LOST -> by + " fell silent in control.";
            case RETURN_DUE -> "Nobody took control after " + by + " had it; the drone is called back.";
            case PILOT_ACTED ->
                by + (change.reason() == null ? "" : " changed the mode to " + change.reason() + " and")
                        + " has control now" + (other == null ? "." : ", not " + whom + ".");
            case PILOT_LEFT -> by + " let go of control.";
            case EXPELLED -> by + ", who had control, may command no more.";
        };
    }
}
