package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Command to a vehicle: report the rally points that it keeps on board. */
@Stored(as = "ReadRallyPoints")
public record ReadRallyPoints() implements Command.Standalone {
    @Override
    public CommandKind kind() {
        return CommandKind.READ_RALLY_POINTS;
    }

    @Override
    public String summary() {
        return "read the rally points";
    }
}
