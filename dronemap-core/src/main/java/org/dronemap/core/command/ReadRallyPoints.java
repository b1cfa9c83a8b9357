package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;

/** Read the rally points that the vehicle keeps. */
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
