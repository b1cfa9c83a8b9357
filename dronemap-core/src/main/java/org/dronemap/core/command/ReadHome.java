package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a vehicle: report its home position. */
@Stored(as = "ReadHome")
public record ReadHome() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_HOME;
    }

    @Override
    public String summary() {
        return "read its home";
    }
}
