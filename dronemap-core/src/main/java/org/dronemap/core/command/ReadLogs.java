package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a vehicle: list the flight logs that it keeps on board. */
@Stored(as = "ReadLogs")
public record ReadLogs() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_LOGS;
    }

    @Override
    public String summary() {
        return "list the logs on board";
    }
}
