package org.dronemap.core.cloud.outlook;

import java.util.Optional;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseHolder;
import org.jspecify.annotations.Nullable;

/** Texts for users about changes of control of a drone. */
public final class ControlMessages {
    private ControlMessages() {}

    /** A user whom these words name; null: nobody. */
    public static @Nullable String user(ControlChange change) {
        return change.by()
                .userName()
                .or(() -> Optional.ofNullable(change.other()).flatMap(LeaseHolder::userName))
                .orElse(null);
    }

    /** Null for what is nothing out of the ordinary. */
    public static @Nullable String of(ControlChange change) {
        String by = change.by().words();
        LeaseHolder other = change.other();
        return switch (change.kind()) {
            case HANDED_OVER -> other == null ? null : by + " handed control over to " + other.words() + ".";
            case TAKEN_OVER ->
                other == null ? null : by + " took control over from " + other.words() + ": " + change.reason();
            case LOST -> "Contact with " + by + ", who had control, was lost.";
            case EXPELLED -> by + ", who had control, may not command any more.";
            case RETURN_DUE -> "Nobody took control after " + by + " had it.";
            case PILOT_ACTED ->
                by + " changed the mode to " + change.reason() + " and has control now"
                        + (other == null ? "." : ", not " + other.words() + ".");
            case TAKEN, REQUESTED, REFUSED, RELEASED, EXPIRED, PILOT_LEFT -> null;
        };
    }
}
