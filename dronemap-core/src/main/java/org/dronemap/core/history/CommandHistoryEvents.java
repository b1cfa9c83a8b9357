package org.dronemap.core.history;

import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/** Makes the history event of a command once it has its outcome, dated at the moment it was given. */
final class CommandHistoryEvents {
    private CommandHistoryEvents() {}

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
                outcome.kind().word(),
                outcome.reason());
    }
}
