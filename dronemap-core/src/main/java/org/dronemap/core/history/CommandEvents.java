package org.dronemap.core.history;

import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/** What is remembered of a command: one event, at the moment when it was given, once its outcome is there. */
final class CommandEvents {
    private CommandEvents() {}

    /** Null while it is under way. */
    static @Nullable HistoryEvent of(CommandRecord command) {
        Outcome outcome = command.outcome();
        if (outcome == null) {
            return null;
        }
        return new HistoryEvent(
                command.drone(),
                command.at(),
                HistoryEvent.Kind.COMMAND,
                command.summary(),
                null,
                command.by(),
                command.id().value(),
                result(outcome),
                reason(outcome));
    }

    private static String result(Outcome outcome) {
        if (outcome instanceof Outcome.Succeeded) {
            return "succeeded";
        }
        if (outcome instanceof Outcome.Refused) {
            return "refused";
        }
        if (outcome instanceof Outcome.Failed) {
            return "failed";
        }
        if (outcome instanceof Outcome.TimedOut) {
            return "timedOut";
        }
        return outcome instanceof Outcome.Superseded ? "superseded" : "unknown";
    }

    private static @Nullable String reason(Outcome outcome) {
        if (outcome instanceof Outcome.Refused refused) {
            return refused.reason();
        }
        if (outcome instanceof Outcome.Failed failed) {
            return failed.reason();
        }
        if (outcome instanceof Outcome.TimedOut timedOut) {
            return timedOut.reason();
        }
        if (outcome instanceof Outcome.Superseded superseded) {
            return superseded.reason();
        }
        return outcome instanceof Outcome.Unknown unknown ? unknown.reason() : null;
    }
}
