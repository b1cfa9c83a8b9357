package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a vehicle: report the fence that it keeps on board. */
@Stored(as = "ReadFence")
public record ReadFence() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_FENCE;
    }

    @Override
    public String summary() {
        return "read the fence";
    }
}
